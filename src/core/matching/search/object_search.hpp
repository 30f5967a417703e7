// SPDX-License-Identifier: BSD-3-Clause
// Searches one object with all of its views.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/search/view_search.hpp"

namespace mbncc::search {

/// Detections of `object` that include all whose reference points lie in `part` [px] (empty: the
/// whole image); others compete with them. Those of different views at one place compete with each
/// other.
std::vector<decision::Detection> search_object(const prepared::PreparedObject& object,
                                               const scene::SceneImage& scene, const cv::Rect& part,
                                               SearchMode mode);

}  // namespace mbncc::search
