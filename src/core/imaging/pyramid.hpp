// SPDX-License-Identifier: BSD-3-Clause
// Image pyramid: level l has half the resolution of level l - 1.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc::imaging {

constexpr int kSmallestLevel = 4;  ///< [px] least width and height of a level above 0

/// Levels 0 (the image itself, not copied) to `top`; each pixel is the mean of 2 x 2 pixels of the
/// level below; an odd last row or column is dropped. Stops before a level would be smaller than
/// kSmallestLevel. `image` has 8-bit or float channels.
std::vector<cv::Mat> build_pyramid(const cv::Mat& image, int top);
/// Builds the same pyramid in `levels`, reusing the memory of the levels above 0.
void build_pyramid(const cv::Mat& image, int top, std::vector<cv::Mat>& levels);

/// Position in level `level` of a point of level 0: pixel centres are at integers in both.
inline cv::Point2d to_level(cv::Point2d point, int level) {
  const double side = 1 << level;
  return {(point.x + 0.5) / side - 0.5, (point.y + 0.5) / side - 0.5};
}

/// The pixels of level `level` that contain pixels of `region` of level 0, which starts at
/// coordinates of 0 or more.
inline cv::Rect to_level(const cv::Rect& region, int level) {
  const int side = 1 << level;
  const cv::Point low(region.x / side, region.y / side);
  const cv::Point high((region.br().x + side - 1) / side, (region.br().y + side - 1) / side);
  return {low, high};
}

/// Inverse of to_level() of a point.
inline cv::Point2d from_level(cv::Point2d point, int level) {
  const double side = 1 << level;
  return {(point.x + 0.5) * side - 0.5, (point.y + 0.5) * side - 0.5};
}

inline Pose2D from_level(const Pose2D& pose, int level) {
  const cv::Point2d position = from_level(pose.position(), level);
  return {position.x, position.y, pose.theta};
}

}  // namespace mbncc::imaging
