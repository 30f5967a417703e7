// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/equivalent_pose.hpp"

#include <cmath>

namespace mbncc::decision {

bool contains(const cv::Rect& region, cv::Point2d point) {
  constexpr double kHalf = 0.5;  // [px] a pixel's area reaches this far beyond its centre
  return region.empty() || (point.x >= region.x - kHalf && point.y >= region.y - kHalf &&
                            point.x < region.br().x - kHalf && point.y < region.br().y - kHalf);
}

Pose2D equivalent_within(const cv::Rect& region, const Pose2D& pose, int symmetry,
                         cv::Point2d centre) {
  if (symmetry == 1 || contains(region, pose.position())) return pose;
  const cv::Point2d from = pose.position() - centre;
  const cv::Point2d to = cv::Point2d(region.tl() + region.br()) / 2 - centre;
  const auto turned = [&](double turn) {
    const cv::Point2d position = centre + rotate(from, turn);
    return Pose2D{position.x, position.y, wrap_angle(pose.theta + turn)};
  };
  for (int k = 1; k < symmetry; ++k) {
    const Pose2D equivalent = turned(k * 2 * kPi / symmetry);
    if (contains(region, equivalent.position())) return equivalent;
  }
  return symmetry == 0 ? turned(std::atan2(from.cross(to), from.dot(to))) : pose;
}

}  // namespace mbncc::decision
