// SPDX-License-Identifier: BSD-3-Clause
// Re-ranks contour proposals by the object's colours.
#pragma once

#include <cstddef>
#include <vector>

#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_image.hpp"
#include "matching/template/candidate.hpp"

namespace mbncc::search {

/// Of poses at one level, valued by their mean response [-1..1], the `most` best by response plus
/// colour log-odds, best first, with that sum as value. In images too small for colours, only the
/// response is used.
std::vector<templates::Candidate> best_by_colours(const prepared::PreparedView& view,
                                                  const scene::SceneImage& scene,
                                                  std::vector<templates::Candidate> poses,
                                                  std::size_t most);

}  // namespace mbncc::search
