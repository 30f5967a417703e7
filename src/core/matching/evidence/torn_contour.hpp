// SPDX-License-Identifier: BSD-3-Clause
// The outline of an object that moved while the rows of the picture were read.
#pragma once

#include "matching/scene/scene_level.hpp"
#include "matching/template/contour_template.hpp"

namespace mbncc {

/// [agreement] What lies together is torn by chance at most.
constexpr double kTorn = 0.0275;

/// [-2..2] By how much an outline, `scale` times as large as the template, agrees better with the
/// edges about `pose` where its upper and its lower rows lie some pixels apart along x, both turned
/// alike. The pose that suits a torn outline best is turned against both of its parts.
double better_torn(const ContourTemplate& contour, const SceneLevel& scene, const Pose2D& pose,
                   double scale);

}  // namespace mbncc
