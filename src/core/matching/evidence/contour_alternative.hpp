// SPDX-License-Identifier: BSD-3-Clause
// Tests whether an outline fits better at a nearby place.
#pragma once

#include "matching/scene/scene_level.hpp"
#include "matching/template/contour_template.hpp"

namespace mbncc::evidence {

/// [-2..2] Advantage in contour_agreement() over `pose` of the best place 3 to about 10 px away, at
/// about the same rotation, for the contour `scale` times as large. Approximate if negative.
double advantage_elsewhere(const templates::ContourTemplate& contour,
                           const scene::SceneLevel& scene, const Pose2D& pose, double scale);

}  // namespace mbncc::evidence
