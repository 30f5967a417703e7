// SPDX-License-Identifier: BSD-3-Clause
// Coarse search by the map's contour, which is independent of shading.
// After LINE-MOD (Hinterstoisser et al. 2012), with signed responses, so that clutter averages out.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/proposal/contour_bank.hpp"
#include "matching/proposal/search_mask.hpp"
#include "matching/scene/scene_level.hpp"
#include "matching/template/candidate.hpp"

namespace mbncc::proposal {

/// Part of an outline whose mean response counts.
enum class OutlinePart {
  kWhole,
  kThreeQuarters,  ///< the three that fit best; the fourth may be covered
};

/// The best `most` poses in `roi` [px at the bank's level] and `places`; those by the
/// whole outline best first, in different places before their neighbours. Value: mean response
/// [-1..1]. `scene` is the bank's level.
std::vector<templates::Candidate> contour_search(const ContourBank& bank,
                                                 const scene::SceneLevel& scene,
                                                 const cv::Rect& roi, std::size_t most,
                                                 const SearchMask& places = {},
                                                 OutlinePart part = OutlinePart::kWhole);

}  // namespace mbncc::proposal
