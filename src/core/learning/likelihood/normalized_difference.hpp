// SPDX-License-Identifier: BSD-3-Clause
// Difference of two images in units of their noise.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::likelihood {

/// Squared Mahalanobis distance between the images (CV_32FC3) per pixel, CV_32FC1.
cv::Mat normalized_difference(const cv::Mat& before, const cv::Mat& predicted,
                              const cv::Mat& variance, const cv::Matx33f& correlation);

/// Weight of the 3 x 3 mean in pool().
constexpr float kPooledPart = 0.7F;

/// Mixes squared distances with their 3 x 3 mean, which evens out single noisy pixels. Neighbours
/// with much larger distances have little weight, so that a change does not spread beyond its
/// border.
void pool(cv::Mat& values);

}  // namespace mbncc::likelihood
