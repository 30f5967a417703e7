// SPDX-License-Identifier: BSD-3-Clause
// Whether an outline alone would lie better somewhere else nearby.
#pragma once

#include "matching/scene/scene_level.hpp"
#include "matching/template/contour_template.hpp"

namespace mbncc {

/// [agreement] An outline that lies better elsewhere by more contradicts the pose.
constexpr double kContradicts = 0.05;

/// [-2..2] By how much the contour, `scale` times as large, agrees better with the edges from 3 to
/// some 10 px away from `pose`, turned a little there, than at it; see contour_agreement(). Roughly
/// where it does not agree better.
double better_elsewhere(const ContourTemplate& contour, const SceneLevel& scene, const Pose2D& pose,
                        double scale);

}  // namespace mbncc
