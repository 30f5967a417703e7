// SPDX-License-Identifier: BSD-3-Clause
// Re-ranks contour proposals by the object's colours.
#pragma once

#include <vector>

#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_image.hpp"
#include "matching/template/candidate.hpp"

namespace mbncc::search {

/// `poses` by mean response plus weighted colour log-odds, best first; that sum becomes their
/// value. All poses are at one level, and their value is the mean response [-1..1]. In images too
/// small for colours, only the response is used.
std::vector<templates::Candidate> ranked_by_colours(const prepared::PreparedView& view,
                                                    const scene::SceneImage& scene,
                                                    std::vector<templates::Candidate> poses);

}  // namespace mbncc::search
