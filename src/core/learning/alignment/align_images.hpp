// SPDX-License-Identifier: BSD-3-Clause
// Aligns the image after with the one before: compensates camera shift and light.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::alignment {

struct AlignedPair {
  cv::Rect window;    ///< [px] of the images: the region and a ring of platform around it
  cv::Mat before;     ///< CV_32FC3, the window of `before`
  cv::Mat after;      ///< CV_32FC3, the window of `after` in the camera pose and light of `before`
  cv::Mat trusted;    ///< CV_8UC1, 255 on ring pixels that show unchanged platform
  cv::Point2d shift;  ///< [px] compensated camera shift
  bool predicted = false;  ///< `after` was predicted from `before`
};

/// `before` and `after` are CV_8UC3 of one size, `region` lies inside them and contains the change.
/// `changed` is ChangeSurvey::changed; if the region leaves too little of the ring, the unchanged
/// pixels of the window replace it.
AlignedPair align_images(const cv::Mat& before, const cv::Mat& after, const cv::Rect& region,
                         const cv::Mat& changed, double max_shift);

}  // namespace mbncc::alignment
