// SPDX-License-Identifier: BSD-3-Clause
// Detects the outline of an object that moved while the rows of the image were read.
#pragma once

#include "matching/scene/scene_level.hpp"
#include "matching/template/contour_template.hpp"

namespace mbncc::evidence {

/// [agreement] Advantage that an intact outline does not reach by chance.
constexpr double kTorn = 0.0275;

/// [-2..2] Advantage in agreement of a torn outline over an intact one near `pose`, both `scale`
/// times as large as the template. The upper and lower part of the torn outline are displaced along
/// x by some pixels, at the same rotation. Other rotations than that of `pose` are tried, because
/// the best pose of a torn object is rotated relative to both of its parts.
double advantage_torn(const templates::ContourTemplate& contour, const scene::SceneLevel& scene,
                      const Pose2D& pose, double scale);

}  // namespace mbncc::evidence
