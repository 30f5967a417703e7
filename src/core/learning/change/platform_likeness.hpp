// SPDX-License-Identifier: BSD-3-Clause
// How much of a changed area shows the platform in both images.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::change {

/// [0..1] Part of `map` (CV_8UC1, not empty) whose colours in `before` are as frequent as those
/// that `after` shows there (both CV_8UC3): 0 if an object left whose colours the platform under it
/// lacks, about 1 if only the platform's texture moved.
double platform_likeness(const cv::Mat& before, const cv::Mat& after, const cv::Mat& map);

}  // namespace mbncc::change
