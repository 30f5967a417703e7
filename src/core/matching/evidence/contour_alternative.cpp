// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/contour_alternative.hpp"

#include <algorithm>
#include <cmath>

#include "matching/evidence/contour_alignment.hpp"

namespace mbncc::evidence {

double advantage_elsewhere(const templates::ContourTemplate& contour,
                           const scene::SceneLevel& scene, const Pose2D& pose, double scale) {
  constexpr double kNearest = 2.9;    // [px] nearer poses are the same place within its accuracy
  constexpr double kStep = 2;         // [px] small enough not to skip an edge
  constexpr int kFarthest = 3;        // steps along x and y
  constexpr double kWorse = 0.1;      // difference in agreement that alignment cannot make up for
  constexpr int kAlignmentSteps = 4;  // steps of a pixel
  constexpr double kSlack = 20;       // [px] more than the distance to the farthest place
  ContourAlignment agreement(contour, scene.around(pose, scale * contour.radius() + kSlack), scale);
  const auto elsewhere = [&](const Pose2D& other) {
    return std::hypot(other.x - pose.x, other.y - pose.y) >= kNearest;
  };
  const double here = agreement.at(pose);
  double best = -1;
  for (int i = -kFarthest; i <= kFarthest; ++i)
    for (int j = -kFarthest; j <= kFarthest; ++j) {
      const Pose2D start{pose.x + kStep * i, pose.y + kStep * j, pose.theta};
      if (!elsewhere(start)) continue;
      AlignedContourPose there{start, agreement.at(start)};
      if (there.agreement > here - kWorse)
        there = agreement.aligned(start, kAlignmentSteps, elsewhere);
      best = std::max(best, there.agreement);
    }
  return best - here;
}

}  // namespace mbncc::evidence
