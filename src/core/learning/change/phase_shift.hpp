// SPDX-License-Identifier: BSD-3-Clause
// Phase correlation of two pictures.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// [px] What `after` was moved by against `before`, up to half their size: undo_shift() takes it
/// back. Both are CV_32FC1 of one size. As cv::phaseCorrelate() under a Hanning window, in a
/// quarter of its memory.
cv::Point2d phase_shift(const cv::Mat& before, const cv::Mat& after);

}  // namespace mbncc
