// SPDX-License-Identifier: BSD-3-Clause
// From the views of one object to what is found of it in a picture.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/search/view_search.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc {

/// Detections of `object` whose reference points lie in `roi` [px] (empty: the whole picture),
/// those of all views compared with each other.
std::vector<Detection> search_object(const PreparedObject& object, const ScenePicture& scene,
                                     const cv::Rect& roi, SearchMode look);

/// Detections of `object` in `roi`, as above, where something else of its size lies that `found`,
/// of the same object, leaves out.
std::vector<Detection> search_occupied(const PreparedObject& object, const ScenePicture& scene,
                                       const cv::Rect& roi, const std::vector<Footprint>& occupied,
                                       const std::vector<Detection>& found);

}  // namespace mbncc
