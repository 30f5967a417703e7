// Whether an outline alone would lie better somewhere else nearby.
#pragma once

#include "matching/contour_template.hpp"
#include "matching/scene_level.hpp"

namespace mbncc {

/// [-2..2] By how much the contour, `scale` times as large, agrees better with the edges at the
/// best place from 3 to some 10 px away from `pose`, turned a little there, than at `pose`; see
/// contour_agreement(). Roughly where it does not agree better.
double better_elsewhere(const ContourTemplate& contour, const SceneLevel& scene, const Pose2D& pose,
                        double scale);

}  // namespace mbncc
