// SPDX-License-Identifier: BSD-3-Clause
// Converts pictures and poses for the point kernels.
#pragma once

#include <cmath>
#include <opencv2/core.hpp>

#include "mbncc/geometry.hpp"
#include "simd/point_kernels.hpp"

namespace mbncc::imaging {

/// `picture` has 8-bit channels and outlives the view.
inline kernels::Picture8 view_of(const cv::Mat& picture) {
  return {picture.data, static_cast<int>(picture.step), picture.cols, picture.rows};
}

/// For an object `scale` times as large as its points.
inline kernels::Placement placement_of(const Pose2D& pose, double scale = 1) {
  const auto theta = static_cast<float>(pose.theta), factor = static_cast<float>(scale);
  return {factor * std::cos(theta), factor * std::sin(theta), static_cast<float>(pose.x),
          static_cast<float>(pose.y)};
}

}  // namespace mbncc::imaging
