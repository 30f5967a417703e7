// SPDX-License-Identifier: BSD-3-Clause
// Detects rows of an image that were taken or transmitted displaced.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::evidence {

/// Whether `grey` (CV_8UC1) is displaced along x, by 3 to 14 px, from one row in the middle three
/// fifths of `box` on, an object's bounding box, which may lie outside.
bool has_torn_rows(const cv::Mat& grey, const cv::Rect& box);

}  // namespace mbncc::evidence
