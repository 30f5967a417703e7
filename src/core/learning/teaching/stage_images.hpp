// SPDX-License-Identifier: BSD-3-Clause
// Images of a lesson's steps for display.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::teaching {

/// `image` with the pixels of `mask` (CV_8UC1) tinted and the region framed.
cv::Mat tinted(const cv::Mat& image, const cv::Mat& mask, const cv::Rect& region);

/// `image` with the outline of `map` drawn.
cv::Mat outlined(const cv::Mat& image, const cv::Mat& map);

}  // namespace mbncc::teaching
