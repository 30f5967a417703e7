// SPDX-License-Identifier: BSD-3-Clause
// Area of an outline.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace mbncc::imaging {

/// CV_8UC1 of `box`'s size: 255 within `outline` [px], whose corners are rounded to pixels.
cv::Mat filled(const std::vector<cv::Point2f>& outline, const cv::Rect& box);

}  // namespace mbncc::imaging
