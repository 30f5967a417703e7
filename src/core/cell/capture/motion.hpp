// SPDX-License-Identifier: BSD-3-Clause
// Detects motion between two images of a still camera.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::capture {

/// Small grey version (CV_32FC1, about 160 px wide) of a CV_8UC3 image, for has_moved().
cv::Mat motion_image(const cv::Mat& image);

/// Whether a patch of a few pixels differs by more than the noise of the pair. `a` and `b` are from
/// motion_image(). A global difference of exposure is not motion.
bool has_moved(const cv::Mat& a, const cv::Mat& b);

}  // namespace mbncc::capture
