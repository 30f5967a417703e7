// SPDX-License-Identifier: BSD-3-Clause
// Tests whether the platform's fine texture is still visible: a shadow darkens it, an object covers
// it.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::likelihood {

/// Log-odds, per pixel, that the texture of `after` is covered in `before` rather than dimmed by
/// the factor `light` (CV_32FC1); about 0 without texture. `before`, `after` and `variance`, that
/// of their difference, are CV_32FC3.
cv::Mat texture_loss(const cv::Mat& before, const cv::Mat& after, const cv::Mat& light,
                     const cv::Mat& variance);

}  // namespace mbncc::likelihood
