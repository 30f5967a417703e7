// SPDX-License-Identifier: BSD-3-Clause
// White noise of 8-bit images.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::imaging {

/// [grey levels] Standard deviation of the noise of `image` (CV_8UC1 or CV_8UC3), the largest of
/// its channels, where `mask` (CV_8UC1; empty: everywhere) is set: of its finest structure
/// (Immerkaer 1996), by the median. Fine texture counts as noise; compressed images have little.
double noise_deviation(const cv::Mat& image, const cv::Mat& mask = {});

/// `image` smoothed between its edges (bilateral filter, Tomasi and Manduchi 1998) by as much as
/// `deviation` [grey levels] of noise asks for; `image` itself where that is little.
cv::Mat without_noise(const cv::Mat& image, double deviation);

}  // namespace mbncc::imaging
