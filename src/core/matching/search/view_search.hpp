// SPDX-License-Identifier: BSD-3-Clause
// From all poses of one view down to a few refined ones.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/decision/detection.hpp"

namespace mbncc {

/// How much a view that is not found at once is worth.
enum class SearchMode {
  kSparing,  ///< where many objects are searched, most are not in the picture ...
  kGated,    ///< ... and only where its colours are
  kQuick,    ///< where another view may find the object
  kTwice     ///< again with more candidates and starts where nothing is found
};

/// Most of what is searched so will not be found.
inline bool is_sparing(SearchMode look) {
  return look == SearchMode::kSparing || look == SearchMode::kGated;
}

/// Candidates of `view` whose anchors lie in `roi` [px] and `places`, refined to full resolution,
/// best first. Several may describe one place: other angles are needed to judge the margin.
std::vector<Detection> search_view(const PreparedObject& object, const PreparedView& view,
                                   const ScenePicture& scene, const cv::Rect& roi, SearchMode look,
                                   const SearchMask& places = {});

/// The best poses of `view` about places [px], whether or not a search proposes them: where another
/// object was found, its look-alikes are to be compared with it.
std::vector<Detection> judge_places(const PreparedObject& object, const PreparedView& view,
                                    const ScenePicture& scene,
                                    const std::vector<cv::Point2d>& centres);

}  // namespace mbncc
