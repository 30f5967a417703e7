// SPDX-License-Identifier: BSD-3-Clause
// The platform under an object, predicted from the ring around it: the picture after that a lesson
// from one picture lacks.
#pragma once

#include <opencv2/core.hpp>

#include "learning/change/align_pictures.hpp"

namespace mbncc {

/// `before` (CV_8UC3) and, as `after`, the second-degree surface that fits the colours of the ring
/// around `region` best (least squares with Tukey's weights). `trusted` are the ring's pixels that
/// it explains; all of the ring where it explains less than half.
AlignedPair predict_platform(const cv::Mat& before, const cv::Rect& region);

}  // namespace mbncc
