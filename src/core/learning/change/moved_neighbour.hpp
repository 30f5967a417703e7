// SPDX-License-Identifier: BSD-3-Clause
// Detects objects next to the taught one that were moved by a few pixels.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::change {

/// 255 on the pixels of `changed` (CV_8UC1) whose surroundings in `before` are found within about
/// 16 pixels in `after`, displaced like their neighbours. Images are CV_32FC3, aligned; `sigma`
/// [grey levels] is the noise of their difference.
cv::Mat moved_neighbours(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                         float sigma);

}  // namespace mbncc::change
