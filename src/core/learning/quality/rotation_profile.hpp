// SPDX-License-Identifier: BSD-3-Clause
// Self-similarity of the object under rotation.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/object_model.hpp"

namespace mbncc::quality {

/// Self-similarity of an object under rotation about its centroid.
class RotationProfile {
 public:
  /// `image` (CV_8UC3) shows the object of `view` where it was learned.
  RotationProfile(const View& view, const cv::Mat& image);

  /// Rotation [rad] at which the similarity has fallen to `level`; pi if it does not.
  double fall_to(double level) const;

 private:
  static constexpr int kSteps = 180;  ///< steps of 2 degrees

  std::vector<double> similarity_;  ///< [-1..1] per step
};

}  // namespace mbncc::quality
