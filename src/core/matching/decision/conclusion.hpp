// SPDX-License-Identifier: BSD-3-Clause
// Whether a match may be grasped, and why not.
#pragma once

#include <vector>

#include "matching/decision/detection.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc {

/// What speaks against grasping `match`, found as `detection`, competitors aside. `cautious`: the
/// covariance of its pose that a grasp is judged by. `instance_margin`: see margins.hpp.
std::vector<Doubt> doubts_about(const Match& match, const Detection& detection,
                                const cv::Matx33d& cautious, double instance_margin,
                                const SearchConfig& config);

/// Sets margin_place, graspable, ambiguous and reasons by score, competitors and doubts.
void conclude(Match& match, const SearchConfig& config);

}  // namespace mbncc
