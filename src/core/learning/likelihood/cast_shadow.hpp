// SPDX-License-Identifier: BSD-3-Clause
// Hard shadows in which the platform's texture stays visible.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::likelihood {

/// CV_8UC1, 255 where `before` is the platform of `after` in one lower light: the connected parts
/// whose colours are darker by about the same factor, and whose texture is
/// that of `after`. Both images CV_32FC3.
cv::Mat cast_shadow(const cv::Mat& before, const cv::Mat& after);

}  // namespace mbncc::likelihood
