// SPDX-License-Identifier: BSD-3-Clause
// Verification: poses at full resolution, refined, and what speaks against them.
#pragma once

#include <vector>

#include "matching/decision/detection.hpp"
#include "matching/scene/scene_picture.hpp"
#include "matching/search/pose_hypothesis.hpp"

namespace mbncc {

/// Judges poses of a view against each other, best first. Only what may be reported is refined.
std::vector<Detection> judge(const PreparedObject& object, const PreparedView& view,
                             const ScenePicture& scene, const std::vector<PoseHypothesis>& found);

}  // namespace mbncc
