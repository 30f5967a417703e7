// Whether an outline alone would lie better somewhere else nearby.
#pragma once

#include "matching/contour_template.hpp"
#include "matching/scene_level.hpp"

namespace mbncc {

/// [agreement] An outline that lies better elsewhere by more contradicts the pose.
constexpr double kContradicts = 0.05;

struct Elsewhere {
  Pose2D pose;
  double better = 0;  ///< [-2..2] agreement beyond that at the pose asked for
};

/// Where the contour, `scale` times as large, agrees best with the edges from 3 to some 10 px away
/// from `pose`, turned a little there; see contour_agreement(). Roughly where it does not agree
/// better.
Elsewhere better_elsewhere(const ContourTemplate& contour, const SceneLevel& scene,
                           const Pose2D& pose, double scale);

}  // namespace mbncc
