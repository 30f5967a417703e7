// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a lesson's steps for display.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::teaching {

/// `picture` with the pixels of `mask` (CV_8UC1) tinted and the region framed.
cv::Mat tinted(const cv::Mat& picture, const cv::Mat& mask, const cv::Rect& region);

/// `picture` with the outline of `map` drawn.
cv::Mat outlined(const cv::Mat& picture, const cv::Mat& map);

}  // namespace mbncc::teaching
