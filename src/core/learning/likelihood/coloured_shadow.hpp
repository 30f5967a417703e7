// SPDX-License-Identifier: BSD-3-Clause
// Hard shadows on a coloured platform. Objects seldom have its hue, but black and grey objects are
// common, so on a grey platform darkness alone does not distinguish a shadow from an object.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::likelihood {

/// CV_8UC1, 255 where `before` is darker than `after`, and has its hue and at least most of its
/// saturation. Both CV_32FC3; `sigma` [grey levels] is the noise of a channel's
/// difference.
cv::Mat coloured_shadow(const cv::Mat& before, const cv::Mat& after, float sigma);

}  // namespace mbncc::likelihood
