// SPDX-License-Identifier: BSD-3-Clause
// Converts images and poses for the point kernels.
#pragma once

#include <cmath>
#include <opencv2/core.hpp>

#include "mbncc/geometry.hpp"
#include "simd/point_kernels.hpp"

namespace mbncc::imaging {

/// `image` has 8-bit channels and must outlive the view.
inline kernels::Image8 view_of(const cv::Mat& image) {
  return {image.data, static_cast<int>(image.step), image.cols, image.rows};
}

/// Placement of an object that appears `scale` times as large as its points.
inline kernels::Placement placement_of(const Pose2D& pose, double scale = 1) {
  const auto theta = static_cast<float>(pose.theta), factor = static_cast<float>(scale);
  return {factor * std::cos(theta), factor * std::sin(theta), static_cast<float>(pose.x),
          static_cast<float>(pose.y), factor};
}

}  // namespace mbncc::imaging
