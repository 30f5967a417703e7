// SPDX-License-Identifier: BSD-3-Clause
// Shifts an image with sub-pixel accuracy.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::alignment {

/// `image` (floats) moved so that it shows at x what it showed at x + shift.
cv::Mat undo_shift(const cv::Mat& image, const cv::Point2d& shift);

}  // namespace mbncc::alignment
