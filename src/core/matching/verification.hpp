// Verification: poses at full resolution, refined, and what speaks against them.
#pragma once

#include <vector>

#include "matching/believed.hpp"
#include "matching/detection.hpp"
#include "matching/scene_picture.hpp"

namespace mbncc {

/// Judges poses of a view against each other, best first. Only what may be reported is refined.
std::vector<Detection> judge(const PreparedObject& object, const PreparedView& view,
                             const ScenePicture& scene, const std::vector<Believed>& found);

}  // namespace mbncc
