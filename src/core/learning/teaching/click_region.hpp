// SPDX-License-Identifier: BSD-3-Clause
// Estimates an approximate region from one point on the object.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// 255 on the pixels of `picture` (CV_8UC3) that are nearer to `click` than to the picture's
/// border, distances measured along paths by the change of colour. The click's pixel always belongs
/// to it.
cv::Mat grow_from_click(const cv::Mat& picture, const cv::Point2d& click);

/// 255 on the connected piece of `mask` (CV_8UC1) at the click, or else nearest to it; all 0 where
/// none lies within 15 pixels.
cv::Mat piece_at(const cv::Mat& mask, const cv::Point2d& click);

/// The same of `changed`, pieces less than 9 pixels apart taken as one.
cv::Mat change_at_click(const cv::Mat& changed, const cv::Point2d& click);

}  // namespace mbncc
