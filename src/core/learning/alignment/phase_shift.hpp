// SPDX-License-Identifier: BSD-3-Clause
// Phase correlation of two images.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::alignment {

/// [px] Shift of `after` relative to `before`, up to half their size, for undo_shift(). Both are
/// CV_32FC1 of one size; (0, 0) if a side is less than 3 px. Like cv::phaseCorrelate() with a
/// Hanning window, in a quarter of its memory.
cv::Point2d phase_shift(const cv::Mat& before, const cv::Mat& after);

}  // namespace mbncc::alignment
