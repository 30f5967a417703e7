// SPDX-License-Identifier: BSD-3-Clause
// Score of a candidate at its pyramid level.
#pragma once

#include <vector>

#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_image.hpp"
#include "matching/template/candidate.hpp"

namespace mbncc::search {

/// Log-odds that `view` lies at `pose` [px at level].
double candidate_odds(const prepared::PreparedView& view, const scene::SceneImage& scene, int level,
                      const Pose2D& pose);

/// Local maxima of the agreement with `object` at a place over a full turn, in steps of `arc` [px]
/// at the rim, best first. `scene` is the place's level; the candidates' values are those of
/// align().
std::vector<templates::Candidate> rotation_peaks(const templates::PoseTemplate& object,
                                                 const scene::SceneLevel& scene,
                                                 const templates::Candidate& place, double arc);

}  // namespace mbncc::search
