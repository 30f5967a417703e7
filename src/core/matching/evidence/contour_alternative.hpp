// SPDX-License-Identifier: BSD-3-Clause
// Tests whether an outline, or one of its ends, fits better at a nearby place.
#pragma once

#include "matching/scene/scene_level.hpp"
#include "matching/template/contour_template.hpp"

namespace mbncc::evidence {

/// [-2..2] Advantage in contour_agreement() over `pose` of the best place 3 to about 10 px away, at
/// about the same rotation, for the contour `scale` times as large. Approximate if negative.
double advantage_elsewhere(const templates::ContourTemplate& contour,
                           const scene::SceneLevel& scene, const Pose2D& pose, double scale);

/// Least advantage_of_displaced_end() of an object of another length.
constexpr double kOtherLength = 0.4;

/// [-2..2] Advantage in mean edge response of an end of the contour that is displaced along the
/// contour's main axis, by 4 % to 20 % of its length, over the end at `pose`: the object is longer
/// or shorter there. An end are the points whose normals lie along the axis, in the outer third or
/// twelfth of the length.
double advantage_of_displaced_end(const templates::ContourTemplate& contour,
                                  const scene::SceneLevel& scene, const Pose2D& pose, double scale);

}  // namespace mbncc::evidence
