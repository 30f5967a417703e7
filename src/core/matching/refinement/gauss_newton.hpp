// SPDX-License-Identifier: BSD-3-Clause
// From a pose to the best one near it.
#pragma once

#include "matching/evidence/evidence.hpp"

namespace mbncc {

/// A pose reached by climbing.
struct AlignedPose {
  Pose2D pose;
  double value = 0;  ///< [-2..2] contour agreement plus correlation without shading
};

/// Gauss-Newton ascent of contour agreement plus correlation without shading, from `start` [px at
/// the templates' level], at most `iterations` steps. Returns the best pose met, `start` itself
/// where nothing is better.
AlignedPose align(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& start,
                  int iterations);

/// Ascent of the contour agreement alone, `iterations` steps; `value` is that agreement.
AlignedPose align_contour(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& start,
                          int iterations);

/// A pose reached, with the evidence there: what the last step has read tells that, too.
struct ScoredPose {
  Pose2D pose;
  Evidence evidence;
};

/// Like align().
ScoredPose align_and_score(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& start,
                           int iterations);

}  // namespace mbncc
