// From proposals at coarse pyramid levels down to the best candidates at full resolution.
#pragma once

#include <vector>

#include "matching/candidate.hpp"
#include "matching/effort.hpp"
#include "matching/prepared_object.hpp"
#include "matching/scene_picture.hpp"

namespace mbncc {

using CandidatesPerLevel = std::vector<std::vector<Candidate>>;

/// Candidates that lie more than so many log-odds behind the best are dropped, ...
constexpr double kHopeless = 15;  ///< since no climb makes up for it
constexpr double kNoRival = 12;   ///< at full resolution, since nothing is asked of them

/// Candidates at `level` that are kept, at most.
std::size_t most_at(int level);

/// The view is so narrow that a step of the edge search brings its outline beside itself.
bool is_narrow(const PreparedView& view, const Effort& effort);

/// Judges and climbs what was proposed, level by level. Thin proposals enter one level finer, as
/// `effort` says. Returns the candidates at full resolution, best first.
std::vector<Candidate> descend(const PreparedView& view, const ScenePicture& scene,
                               const Effort& effort, CandidatesPerLevel proposed);

}  // namespace mbncc
