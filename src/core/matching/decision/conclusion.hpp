// SPDX-License-Identifier: BSD-3-Clause
// Decides whether a match is graspable, with reasons.
#pragma once

#include <vector>

#include "matching/decision/detection.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/match.hpp"

namespace mbncc::decision {

/// Reasons against grasping `match`, which was made from `detection`, apart from its competitors.
/// `grasp_covariance`: covariance of the pose used for the grasp conditions.
std::vector<Doubt> doubts_about(const Match& match, const Detection& detection,
                                const cv::Matx33d& grasp_covariance, const SearchConfig& config);

/// Sets margin_place, graspable, ambiguous and reasons from score, competitors and doubts.
void conclude(Match& match, const SearchConfig& config);

}  // namespace mbncc::decision
