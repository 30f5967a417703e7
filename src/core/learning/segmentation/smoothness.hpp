// SPDX-License-Identifier: BSD-3-Clause
// Cost of an outline between neighbouring pixels.
#pragma once

#include <array>
#include <opencv2/core.hpp>

#include "learning/likelihood/noise_model.hpp"

namespace mbncc::segmentation {

/// Weights of the edges to the left, upper left, upper and upper right neighbour, CV_32FC1, 0 where
/// there is no neighbour. Low weights attract the outline.
struct Smoothness {
  static constexpr std::array<int, 4> kDx{-1, -1, 0, 1};
  static constexpr std::array<int, 4> kDy{0, -1, -1, -1};

  std::array<cv::Mat, 4> weights;
  float strength = 0;  ///< the largest weight of a straight edge
};

/// The paper's contrast term, gamma exp(-beta |z_m - z_n|^2) / dist(m, n), on `before`, weakened
/// where `after` shows the same edge, which then belongs to the platform. Both CV_32FC3, aligned.
Smoothness smoothness(const cv::Mat& before, const cv::Mat& after,
                      const likelihood::NoiseModel& noise);

/// A copy whose outline costs nothing along the rim of `mask` (CV_8UC1 of the images' size).
Smoothness with_free_rim(const Smoothness& smoothness, const cv::Mat& mask);

}  // namespace mbncc::segmentation
