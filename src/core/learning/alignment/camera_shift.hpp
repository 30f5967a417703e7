// SPDX-License-Identifier: BSD-3-Clause
// A small camera shift between two images.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::alignment {

/// Luminance of a CV_32FC3 image, lightly smoothed (sigma 1.5): input of the shift estimation.
cv::Mat smooth_luminance(const cv::Mat& image);

/// Displacement d [px] such that before(x) = after(x + d) on the `trusted` pixels (CV_8UC1), by
/// robust Gauss-Newton from 0. (0, 0) if it does not explain the images clearly better than no
/// shift, or if it is shorter than 0.04 or longer than `max_shift` [px]. The images are from
/// smooth_luminance().
cv::Point2d estimate_shift(const cv::Mat& before, const cv::Mat& after, const cv::Mat& trusted,
                           double max_shift);

}  // namespace mbncc::alignment
