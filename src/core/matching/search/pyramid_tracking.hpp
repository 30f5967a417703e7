// SPDX-License-Identifier: BSD-3-Clause
// Coarse-to-fine tracking of proposals down to the best candidates at full resolution.
#pragma once

#include <vector>

#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_image.hpp"
#include "matching/search/search_budget.hpp"
#include "matching/template/candidate.hpp"

namespace mbncc::search {

/// Largest number of candidates kept at `level`.
std::size_t most_at(int level);

/// Scores the proposals of one level and refines them level by level. Returns the candidates at
/// full resolution, best first.
std::vector<templates::Candidate> track_down(const prepared::PreparedView& view,
                                             const scene::SceneImage& scene,
                                             const SearchBudget& budget,
                                             std::vector<templates::Candidate> proposed);

}  // namespace mbncc::search
