// From proposals at a coarse pyramid level down to the best candidates at full resolution.
#pragma once

#include <vector>

#include "matching/candidate.hpp"
#include "matching/effort.hpp"
#include "matching/prepared_object.hpp"
#include "matching/scene_picture.hpp"

namespace mbncc {

/// Candidates at `level` that are kept, at most.
std::size_t most_at(int level);

/// Judges what was proposed at one level and refines it, level by level. Proposals of a thin
/// object enter one level finer, as `effort` says. Returns the candidates at full resolution, best
/// first.
std::vector<Candidate> descend(const PreparedView& view, const ScenePicture& scene,
                               const Effort& effort, std::vector<Candidate> proposed);

}  // namespace mbncc
