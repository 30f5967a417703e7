// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/object_search.hpp"

#include <algorithm>

#include "matching/prepared/prepared_object.hpp"
#include "matching/search/search_budget.hpp"

namespace mbncc::search {
namespace {

/// Possible anchors of a view whose reference point lies in `roi`, in any size that a refinement
/// reaches.
cv::Rect anchor_region(const cv::Rect& roi, const prepared::PreparedView& view, cv::Size size) {
  constexpr double kLargest = 1.1;
  const cv::Rect image({0, 0}, size);
  if (roi.empty()) return image;
  const int lever = cvCeil(kLargest * cv::norm(view.reference_in_anchor.position()));
  return cv::Rect(roi.x - lever, roi.y - lever, roi.width + 2 * lever, roi.height + 2 * lever) &
         image;
}

std::vector<decision::Detection> search_views(const prepared::PreparedObject& object,
                                              const scene::SceneImage& scene, const cv::Rect& roi,
                                              SearchMode mode) {
  std::vector<decision::Detection> found;
  for (const auto& view : object.views) {
    const auto detections =
        search_view(object, view, scene, anchor_region(roi, view, scene.size()), mode);
    found.insert(found.end(), detections.begin(), detections.end());
  }
  return object.views.size() > 1 ? decision::resolve_rotations(std::move(found)) : found;
}

/// Number of places in `roi` with a likely detection.
std::size_t likely_places(const std::vector<decision::Detection>& detections, const cv::Rect& roi) {
  std::vector<const decision::Detection*> places;
  for (const auto& one : detections)
    if (one.log_odds() >= kMinFoundOdds && decision::reference_within(one, roi) &&
        std::none_of(places.begin(), places.end(), [&](const decision::Detection* other) {
          return decision::at_one_place(one, *other);
        }))
      places.push_back(&one);
  return places.size();
}

}  // namespace

std::vector<decision::Detection> search_object(const prepared::PreparedObject& object,
                                               const scene::SceneImage& scene, const cv::Rect& roi,
                                               SearchMode mode) {
  if (object.views.front().polar) return search_views(object, scene, roi, mode);
  if (is_reduced(mode)) {
    // Its few candidates do not suffice for many instances.
    const auto found = search_views(object, scene, roi, mode);
    return likely_places(found, roi) < kManyFound
               ? found
               : search_object(object, scene, roi, SearchMode::kThorough);
  }
  if (object.views.size() == 1) return search_views(object, scene, roi, mode);
  // An instance fits one of several views best, so all views are searched thoroughly only if the
  // quick search finds nothing.
  const auto found = search_views(object, scene, roi, SearchMode::kQuick);
  return likely_places(found, roi) > 0 ? found : search_views(object, scene, roi, mode);
}

}  // namespace mbncc::search
