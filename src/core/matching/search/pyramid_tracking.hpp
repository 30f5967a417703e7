// SPDX-License-Identifier: BSD-3-Clause
// From proposals at a coarse pyramid level down to the best candidates at full resolution.
#pragma once

#include <vector>

#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_picture.hpp"
#include "matching/search/search_budget.hpp"
#include "matching/template/candidate.hpp"

namespace mbncc {

/// Candidates at `level` that are kept, at most.
std::size_t most_at(int level);

/// Judges what was proposed at one level and refines it, level by level. Proposals of a thin
/// object enter one level finer, as `effort` says. Returns the candidates at full resolution, best
/// first.
std::vector<Candidate> descend(const PreparedView& view, const ScenePicture& scene,
                               const SearchBudget& effort, std::vector<Candidate> proposed);

}  // namespace mbncc
