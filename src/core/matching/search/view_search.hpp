// SPDX-License-Identifier: BSD-3-Clause
// Searches one view: from all poses to a few refined ones.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/decision/detection.hpp"
#include "matching/prepared/prepared_object.hpp"

namespace mbncc::search {

/// How thoroughly and where a view is searched.
enum class SearchMode {
  kReduced,            ///< with few candidates, because most of many objects are not in the image
  kColourPrefiltered,  ///< like kReduced, but only where the object's colours occur
  kThorough            ///< again with more candidates if none or many instances are found
};

/// Whether few candidates are used, because most objects are absent.
inline bool is_reduced(SearchMode mode) {
  return mode == SearchMode::kReduced || mode == SearchMode::kColourPrefiltered;
}

/// Candidates of `view` whose anchors lie in `roi` [px], refined to full resolution,
/// best first. Several may describe one place, because other angles are needed for the margin.
std::vector<decision::Detection> search_view(const prepared::PreparedObject& object,
                                             const prepared::PreparedView& view,
                                             const scene::SceneImage& scene, const cv::Rect& roi,
                                             SearchMode mode);

}  // namespace mbncc::search
