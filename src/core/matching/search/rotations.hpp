// SPDX-License-Identifier: BSD-3-Clause
// The rotations in which an object may lie at a place.
#pragma once

#include <vector>

#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_image.hpp"
#include "matching/template/candidate.hpp"

namespace mbncc::search {

/// The best rotations of `view` at a place at full resolution, aligned, best first; the values are
/// log-odds.
std::vector<templates::Candidate> rotations_at(const prepared::PreparedView& view,
                                               const scene::SceneImage& scene,
                                               const templates::Candidate& place);

}  // namespace mbncc::search
