// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/object_search.hpp"

#include <algorithm>

#include "imaging/rectangles.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/search/search_budget.hpp"

namespace mbncc::search {
namespace {

/// Possible anchors of a view whose reference point lies in `part`, in any size that a refinement
/// reaches.
cv::Rect anchor_region(const cv::Rect& part, const prepared::PreparedView& view, cv::Size size) {
  constexpr double kLargest = 1.1;
  const cv::Rect image({0, 0}, size);
  if (part.empty()) return image;
  const int lever = cvCeil(kLargest * cv::norm(view.reference_in_anchor.position()));
  return imaging::grown(part, lever) & image;
}

std::vector<decision::Detection> search_views(const prepared::PreparedObject& object,
                                              const scene::SceneImage& scene, const cv::Rect& part,
                                              SearchMode mode) {
  std::vector<decision::Detection> found;
  for (const auto& view : object.views) {
    const auto detections =
        search_view(object, view, scene, anchor_region(part, view, scene.size()), mode);
    found.insert(found.end(), detections.begin(), detections.end());
  }
  return object.views.size() > 1 ? decision::resolve_rotations(std::move(found)) : found;
}

/// Number of places in `part` (empty: the whole image) with a likely detection.
std::size_t count_likely_places(const std::vector<decision::Detection>& detections,
                                const cv::Rect& part) {
  std::vector<const decision::Detection*> places;
  for (const auto& one : detections)
    if (one.log_odds() >= kMinFoundOdds && decision::reference_within(one, part) &&
        std::none_of(places.begin(), places.end(), [&](const decision::Detection* other) {
          return decision::at_one_place(one, *other);
        }))
      places.push_back(&one);
  return places.size();
}

}  // namespace

std::vector<decision::Detection> search_object(const prepared::PreparedObject& object,
                                               const scene::SceneImage& scene, const cv::Rect& part,
                                               SearchMode mode) {
  const auto found = search_views(object, scene, part, mode);
  // The few candidates of a reduced search do not suffice for many instances.
  const bool is_complete = !is_reduced(mode) || object.views.front().polar ||
                           count_likely_places(found, part) < kManyFound;
  return is_complete ? found : search_views(object, scene, part, SearchMode::kThorough);
}

}  // namespace mbncc::search
