// SPDX-License-Identifier: BSD-3-Clause
// Makes the picture after the grasp comparable with the one before it: camera shift and light.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

struct AlignedPair {
  cv::Rect window;  ///< [px] of the pictures: the region and a ring of platform around it
  cv::Mat before;   ///< CV_32FC3, the window of `before`
  cv::Mat after;    ///< CV_32FC3, the window of `after` as the other camera pose and light show it
  cv::Mat trusted;  ///< CV_8UC1, 255 on ring pixels that show unchanged platform
  cv::Point2d shift;  ///< [px] that was undone
};

/// `before` and `after` are CV_8UC3 of one size, `region` lies inside them and holds the change.
/// `changed` is the survey's; it takes the ring's place where the region leaves too little of it.
AlignedPair align_pictures(const cv::Mat& before, const cv::Mat& after, const cv::Rect& region,
                           const cv::Mat& changed, double max_shift);

}  // namespace mbncc
