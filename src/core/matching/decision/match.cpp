// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/match.hpp"

#include <cmath>

namespace mbncc {

Match equivalent_towards(double theta, Match match) {
  if (match.symmetry == 1) return match;
  const double part = match.symmetry == 0 ? 0 : 2 * kPi / match.symmetry;
  const double turned =
      part > 0 ? wrap_angle(theta + std::remainder(match.pose.theta - theta, part)) : theta;
  const cv::Point2d centre = match.pose.position() + match.to_symmetry_centre;
  match.to_symmetry_centre = rotate(match.to_symmetry_centre, turned - match.pose.theta);
  const cv::Point2d shift = centre - match.to_symmetry_centre - match.pose.position();
  match.pose = {match.pose.x + shift.x, match.pose.y + shift.y, turned};
  match.covariance = covariance_at(match.covariance, shift);
  return match;
}

}  // namespace mbncc
