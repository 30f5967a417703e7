// SPDX-License-Identifier: BSD-3-Clause
// Connected groups of the pixels in which an image differs from a lesson.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <vector>

namespace mbncc::evidence {

struct Group {
  cv::Rect box;
  cv::Point2d centre;
  int size = 0;  ///< [px]
  cv::Mat mask;  ///< CV_8UC1 in the box: 255 at its pixels
};

/// Connected groups of `pixels` (CV_8UC1).
std::vector<Group> connected_groups(const cv::Mat& pixels);

/// Numbers of pixels.
struct LargestGroups {
  int largest = 0;
  int enclosed = 0;  ///< of the groups that stay off the rim of the compared area
};

/// Largest groups of `differing` within `compared` (both CV_8UC1) whose centres satisfy `counts`.
/// `rim` [px]: width of the rim.
LargestGroups largest_groups(const cv::Mat& differing, const cv::Mat& compared, int rim,
                             const std::function<bool(const cv::Point2d&)>& counts);

}  // namespace mbncc::evidence
