// SPDX-License-Identifier: BSD-3-Clause
// The rotations in which an object may lie at a place.
#pragma once

#include <vector>

#include "matching/scene/scene_level.hpp"
#include "matching/template/candidate.hpp"
#include "matching/template/pose_sample.hpp"

namespace mbncc::search {

/// Local maxima of the agreement with `object` at a place over a full turn, in steps of `arc` [px]
/// at the rim, best first. `scene` is the place's level; the candidates' values are those of
/// align().
std::vector<templates::Candidate> rotation_peaks(const templates::PoseTemplate& object,
                                                 const scene::SceneLevel& scene,
                                                 const templates::Candidate& place, double arc);

}  // namespace mbncc::search
