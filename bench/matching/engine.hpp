// SPDX-License-Identifier: BSD-3-Clause
// What every matching engine of the benchmark does: it is shown one object and finds it in
// images.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc::bench {

/// A detection: a learned point p appears at (x, y) + R(theta) (p - reference).
struct Found {
  Pose2D pose;
  double score = 0;
  bool graspable = false;                 ///< the engine vouches for it: a robot may grip there
  std::optional<cv::Matx33d> covariance;  ///< of x, y, theta, where the engine claims one
};

class Engine {
 public:
  virtual ~Engine() = default;

  /// Replaces the object. `image` is CV_8UC3, `map` CV_8UC1 of its size (255 on the object).
  virtual void teach(const cv::Mat& image, const cv::Mat& map, cv::Point2d reference) = 0;

  /// Every detection worth a look, weak ones too: thresholds are set afterwards.
  virtual std::vector<Found> find(const cv::Mat& image) = 0;

  /// The threshold it ships with; none: the benchmark takes the one with the best F1.
  virtual std::optional<double> threshold() const { return {}; }
};

/// Names of all engines in the order of the table.
std::vector<std::string> engine_names();

/// Throws std::invalid_argument listing the names when there is none of that name.
std::unique_ptr<Engine> make_engine(const std::string& name);

}  // namespace mbncc::bench
