// SPDX-License-Identifier: BSD-3-Clause
// Which of the many poses that lie on edges show the object's colours, too.
#pragma once

#include <cstddef>
#include <vector>

#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_picture.hpp"
#include "matching/template/candidate.hpp"

namespace mbncc {

/// Of poses at one level, valued by their mean response [-1..1], the `most` that the response and
/// what the colours under them say speak for, best first; valued by both. In pictures too small for
/// colours the response alone decides.
std::vector<Candidate> best_by_colours(const PreparedView& view, const ScenePicture& scene,
                                       std::vector<Candidate> poses, std::size_t most);

}  // namespace mbncc
