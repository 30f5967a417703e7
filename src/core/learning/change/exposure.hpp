// SPDX-License-Identifier: BSD-3-Clause
// Exposure ratio of two pictures of one scene.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::change {

struct Exposure {
  cv::Vec3f gain{1, 1, 1};  ///< gain that makes the picture after as bright as the one before
  double mean = 1;          ///< of the gain over the channels
  double unevenness = 1;    ///< largest over smallest gain of the picture's quarters
};

/// Medians over pixels, so that changes in less than half of a picture have no influence. Both
/// pictures are CV_8UC3 and of one size.
Exposure exposure_of(const cv::Mat& before, const cv::Mat& after);

}  // namespace mbncc::change
