// From a pose to the best one near it.
#pragma once

#include "matching/evidence.hpp"

namespace mbncc {

/// A pose reached by climbing.
struct Climbed {
  Pose2D pose;
  double value = 0;  ///< [-2..2] contour agreement plus correlation without shading
};

/// Gauss-Newton ascent of contour agreement plus correlation without shading, from `start` [px at
/// the templates' level], at most `iterations` steps. Returns the best pose met, `start` itself
/// where nothing is better.
Climbed climb(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& start,
              int iterations);

/// Ascent of the contour agreement alone, `iterations` steps; `value` is that agreement.
Climbed follow_contour(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& start,
                       int iterations);

/// A pose reached, with the evidence there: what the last step has read tells that, too.
struct Supported {
  Pose2D pose;
  Evidence evidence;
};

/// Like climb().
Supported climb_to_evidence(const PoseTemplate& object, const SceneLevel& scene,
                            const Pose2D& start, int iterations);

}  // namespace mbncc
