// SPDX-License-Identifier: BSD-3-Clause
// Things beside the object that were nudged: the picture before shows what the picture after shows
// a few pixels on.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// 255 on the pixels of `changed` (CV_8UC1) whose surroundings in `before` lie within about 16
/// pixels in `after`, displaced like their neighbours. Pictures are CV_32FC3, aligned; `sigma`
/// [grey levels] is the noise of their difference.
cv::Mat moved_neighbours(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                         float sigma);

}  // namespace mbncc
