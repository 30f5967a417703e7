// SPDX-License-Identifier: BSD-3-Clause
// Detects rows of an image that are displaced by motion or by faulty transmission.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::scene {

/// Whether `grey` (CV_8UC1) is displaced along x, by 3 to 14 px, from one row on. Only the middle
/// three fifths of the rows of `box` are tested: the bounding box of an object, which may reach
/// beyond the image.
bool has_torn_rows(const cv::Mat& grey, const cv::Rect& box);

}  // namespace mbncc::scene
