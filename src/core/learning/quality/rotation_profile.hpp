// SPDX-License-Identifier: BSD-3-Clause
// The object turned on the spot: how sharply does its likeness to itself fall?
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

 private:
  static constexpr int kSteps = 180;  ///< of 2 degrees

  std::vector<double> similarity_;  ///< [-1..1] per step
};

}  // namespace mbncc
