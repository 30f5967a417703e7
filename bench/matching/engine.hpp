// SPDX-License-Identifier: BSD-3-Clause
// Interface of the benchmark's matching engines: an engine is taught one object and finds it in
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
  bool graspable = false;  ///< the engine considers the pose reliable enough for a robot to grasp
  std::optional<cv::Matx33d> covariance;  ///< of x, y, theta, if the engine states one
};

class Engine {
 public:
  virtual ~Engine() = default;

  /// Replaces the object. `image` is CV_8UC3, `map` is CV_8UC1 of the same size (255 on the
  /// object).
  virtual void teach(const cv::Mat& image, const cv::Mat& map, cv::Point2d reference) = 0;

  /// All detections that may matter, including weak ones: thresholds are applied afterwards.
  virtual std::vector<Found> find(const cv::Mat& image) = 0;

  /// The threshold that the engine ships with; none: the benchmark uses the one with the best F1.
  virtual std::optional<double> threshold() const { return {}; }
};

/// Names of all engines in the order of the table.
std::vector<std::string> engine_names();

/// Throws std::invalid_argument that lists the known names if `name` is unknown.
std::unique_ptr<Engine> make_engine(const std::string& name);

}  // namespace mbncc::bench
