// SPDX-License-Identifier: BSD-3-Clause
// Searches one object with all of its views.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/search/view_search.hpp"
#include "mbncc/matching/match.hpp"

namespace mbncc::search {

/// Detections of `object` whose reference points lie in `roi` [px] (empty: the whole image),
/// those of all views compared with each other.
std::vector<decision::Detection> search_object(const prepared::PreparedObject& object,
                                               const scene::SceneImage& scene, const cv::Rect& roi,
                                               SearchMode mode);

/// Detections of `object` in `roi`, as above, at places of other objects of its size that are not
/// in `found`, the detections of the same object.
std::vector<decision::Detection> search_occupied(const prepared::PreparedObject& object,
                                                 const scene::SceneImage& scene,
                                                 const cv::Rect& roi,
                                                 const std::vector<Footprint>& occupied,
                                                 const std::vector<decision::Detection>& found);

}  // namespace mbncc::search
