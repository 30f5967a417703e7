// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/contour_alignment.hpp"

namespace mbncc::evidence {

templates::Candidate shifted_onto_edges(const templates::ContourTemplate& contour,
                                        const scene::SceneLevel& scene,
                                        const templates::Candidate& candidate) {
  constexpr double kStep = 2;    // [px] small enough not to skip an edge
  constexpr int kFarthest = 3;   // steps
  constexpr double kSlack = 10;  // [px] more than the distance to the farthest place
  const Pose2D& pose = candidate.pose;
  ContourAlignment agreement(contour, scene.around(pose, contour.radius() + kSlack));
  templates::Candidate best = candidate;
  best.value = -1;
  for (int i = -kFarthest; i <= kFarthest; ++i)
    for (int j = -kFarthest; j <= kFarthest; ++j) {
      const Pose2D shifted{pose.x + kStep * i, pose.y + kStep * j, pose.theta};
      const double value = agreement.at(shifted);
      if (value > best.value) best = {shifted, candidate.level, value};
    }
  return best;
}

}  // namespace mbncc::evidence
