// SPDX-License-Identifier: BSD-3-Clause
// Gauss-Newton alignment from a pose to the best one near it.
#pragma once

#include "matching/evidence/evidence.hpp"

namespace mbncc::refinement {

/// A pose reached by alignment.
struct AlignedPose {
  Pose2D pose;
  double value = 0;  ///< [-2..2] contour agreement plus correlation without shading
};

/// Gauss-Newton maximisation of contour agreement plus correlation without shading, from `start`
/// [px at the templates' level], at most `iterations` steps. Returns the best pose reached, `start`
/// itself if none is better.
AlignedPose align(const templates::PoseTemplate& object, const scene::SceneLevel& scene,
                  const Pose2D& start, int iterations);

/// A pose reached by alignment, with its evidence.
struct ScoredPose {
  Pose2D pose;
  evidence::Evidence evidence;
};

/// Like align(), with the evidence at the returned pose.
ScoredPose align_and_score(const templates::PoseTemplate& object, const scene::SceneLevel& scene,
                           const Pose2D& start, int iterations);

}  // namespace mbncc::refinement
