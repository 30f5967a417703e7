// The object turned on the spot: how sharply does its likeness to itself fall, and where is it
// back?
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/object_model.hpp"

namespace mbncc {

/// Likeness of an object to itself under rotation about its centroid.
class RotationProfile {
 public:
  /// `picture` (CV_8UC3) shows the object of `view` where it was learned.
  RotationProfile(const View& view, const cv::Mat& picture);

  /// Rotation [rad] at which the similarity has fallen to `level`; pi when it never does.
  double fall_to(double level) const;

  /// How often a turn brings outline and texture back: 1 never, 2 at 180 degrees, 3, 4, 6; 0:
  /// round.
  int symmetry() const;

 private:
  static constexpr int kSteps = 180;  ///< of 2 degrees

  bool returns_at(int step) const;

  std::vector<double> similarity_;  ///< [-1..1] per step
  std::vector<double> overlap_;     ///< [0..1] IoU of the turned map with itself, per step
};

}  // namespace mbncc
