// SPDX-License-Identifier: BSD-3-Clause
// Other poses in which an object may lie at a place.
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

/// The best poses of a long object that are displaced along it, at the same angle, aligned; the
/// values are log-odds. Where an end is hidden, a periodic print leaves its place open. None if the
/// object is not long.
std::vector<templates::Candidate> shifts_at(const prepared::PreparedView& view,
                                            const scene::SceneImage& scene,
                                            const templates::Candidate& place);

}  // namespace mbncc::search
