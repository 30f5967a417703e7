// From one point on the object to an approximate region.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// 255 on the pixels of `picture` (CV_8UC3) that are nearer to `click` than to the picture's
/// border, distances measured along paths by the change of colour. The click's pixel always belongs
/// to it.
cv::Mat grow_from_click(const cv::Mat& picture, const cv::Point2d& click);

/// 255 on the connected patch of `changed` (CV_8UC1) at the click, or else nearest to it, pieces
/// less than 9 pixels apart taken as one; all 0 when nothing changed.
cv::Mat change_at_click(const cv::Mat& changed, const cv::Point2d& click);

}  // namespace mbncc
