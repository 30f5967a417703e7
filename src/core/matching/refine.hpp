// Sub-pixel, sub-degree refinement of a pose on the masked similarity.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/geometry.hpp"
#include "mbncc/matching/similarity.hpp"

namespace mbncc {

struct RefinedPose {
  Pose2D pose;
  double similarity = 0;   ///< [-1..1] at `pose`
  cv::Matx33d covariance;  ///< of x, y, theta [px^2, px rad, rad^2] at the refiner's level
};

/// Inverse compositional Gauss-Newton (Baker & Matthews 2004): the picture, read at the template's
/// points, is fitted by gain * template + offset + gain * slopes * step; the pose moves by the
/// inverse of the step. Slopes and normal equations depend on the template alone and are prepared.
class Refiner {
 public:
  /// As masked_template(); `most_points` thins evenly.
  Refiner(const cv::Mat& grey, const cv::Mat& map, cv::Point2d anchor, int level,
          std::size_t most_points = 4000);

  /// Climbs from `start` [px at the level] for at most `iterations` steps and returns the best pose
  /// met, which is `start` itself where nothing is better.
  RefinedPose refine(const cv::Mat& grey, const Pose2D& start, int iterations) const;

  const MaskedTemplate& points() const { return points_; }

 private:
  struct Sample;
  Sample sample(const cv::Mat& grey, const Pose2D& pose) const;
  cv::Vec<double, 5> fit(const Sample& sample) const;

  MaskedTemplate points_;
  std::vector<float> slope_x_, slope_y_, slope_turn_;  // d template / dx, dy, dtheta
  double mean_ = 0, energy_ = 0;                       // of the template: mean, sum of squares
  cv::Matx<double, 5, 5> inverse_;                     // of the normal equations
  bool solvable_ = false;
};

}  // namespace mbncc
