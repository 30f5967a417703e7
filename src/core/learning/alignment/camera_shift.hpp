// SPDX-License-Identifier: BSD-3-Clause
// A small camera shift between two images.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::alignment {

/// Luminance of a CV_32FC3 image, lightly smoothed (sigma 1.5): input of the shift estimation.
cv::Mat smooth_luminance(const cv::Mat& image);

/// Displacement d [px] such that before(x) = after(x + d) on the `trusted` pixels (CV_8UC1), by
/// robust Gauss-Newton from 0. (0, 0) unless it explains the images clearly better than no shift,
/// and if it is longer than `max_shift`. Images from smooth_luminance().
cv::Point2d estimate_shift(const cv::Mat& before, const cv::Mat& after, const cv::Mat& trusted,
                           double max_shift);

}  // namespace mbncc::alignment
