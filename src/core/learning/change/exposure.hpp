// SPDX-License-Identifier: BSD-3-Clause
// Exposure ratio of two images of one scene.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::change {

struct Exposure {
  cv::Vec3f gain{1, 1, 1};  ///< gain that makes the image after as bright as the one before
  double mean = 1;          ///< mean of the gain over the channels
  double unevenness = 1;    ///< ratio of the largest to the smallest gain of the image's quarters
};

/// Medians over pixels, so that changes in less than half of an image have no influence. Both
/// images are CV_8UC3 and of one size.
Exposure exposure_of(const cv::Mat& before, const cv::Mat& after);

}  // namespace mbncc::change
