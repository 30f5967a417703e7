// SPDX-License-Identifier: BSD-3-Clause
// Searches for an object at the places of other objects.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/decision/detection.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_image.hpp"
#include "mbncc/matching/match.hpp"

namespace mbncc::search {

/// Detections of `object` at the places in `occupied` of other objects of about its size. Leaves
/// out places in `found`, the detections of `object` so far.
std::vector<decision::Detection> search_occupied(const prepared::PreparedObject& object,
                                                 const scene::SceneImage& scene,
                                                 const std::vector<Footprint>& occupied,
                                                 const std::vector<decision::Detection>& found);

/// The best poses of `view` near `centres` [px], whether or not a search proposes them, to compare
/// look-alikes at the places of other objects.
std::vector<decision::Detection> search_places(const prepared::PreparedObject& object,
                                               const prepared::PreparedView& view,
                                               const scene::SceneImage& scene,
                                               const std::vector<cv::Point2d>& centres);

}  // namespace mbncc::search
