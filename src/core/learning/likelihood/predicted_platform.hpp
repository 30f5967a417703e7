// SPDX-License-Identifier: BSD-3-Clause
// Predicts the platform under an object from the ring around it, which replaces the image after in
// a lesson from one image.
#pragma once

#include <opencv2/core.hpp>

#include "learning/alignment/align_images.hpp"

namespace mbncc::likelihood {

/// Returns `before` (CV_8UC3) and, as `after`, the second-degree surface that fits the colours of
/// the ring around `region` best (least squares with Tukey's weights). `trusted` marks the ring's
/// pixels that the surface explains, or the whole ring if it explains less than half.
alignment::AlignedPair predict_platform(const cv::Mat& before, const cv::Rect& region);

}  // namespace mbncc::likelihood
