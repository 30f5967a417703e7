// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/object_search.hpp"

#include <algorithm>
#include <cmath>

#include "matching/prepared/prepared_object.hpp"
#include "matching/search/search_budget.hpp"

namespace mbncc::search {
namespace {

/// Possible anchors of a view whose reference point lies in `roi`.
cv::Rect anchor_region(const cv::Rect& roi, const prepared::PreparedView& view, cv::Size size) {
  const cv::Rect image({0, 0}, size);
  if (roi.empty()) return image;
  const int lever = static_cast<int>(std::ceil(cv::norm(view.reference_in_anchor.position())));
  return cv::Rect(roi.x - lever, roi.y - lever, roi.width + 2 * lever, roi.height + 2 * lever) &
         image;
}

std::vector<decision::Detection> search_views(const prepared::PreparedObject& object,
                                              const scene::SceneImage& scene, const cv::Rect& roi,
                                              SearchMode mode) {
  const bool prefiltered = mode == SearchMode::kColourPrefiltered;
  std::vector<decision::Detection> found;
  for (const auto& view : object.views) {
    const auto detections = search_view(
        object, view, scene, anchor_region(roi, view, scene.size()), mode,
        prefiltered ? view.colour_prefilter.places(scene.classes()) : proposal::SearchMask{});
    std::copy_if(detections.begin(), detections.end(), std::back_inserter(found),
                 [&](const decision::Detection& detection) {
                   return decision::reference_within(detection, roi);
                 });
  }
  return object.views.size() > 1 ? decision::resolve_rotations(std::move(found)) : found;
}

/// Number of likely detections.
std::size_t likely(const std::vector<decision::Detection>& detections) {
  return static_cast<std::size_t>(std::count_if(
      detections.begin(), detections.end(),
      [](const decision::Detection& one) { return one.log_odds() >= kMinFoundOdds; }));
}

}  // namespace

std::vector<decision::Detection> search_object(const prepared::PreparedObject& object,
                                               const scene::SceneImage& scene, const cv::Rect& roi,
                                               SearchMode mode) {
  if (is_reduced(mode)) {
    // Its few candidates do not suffice for many instances.
    const auto found = search_views(object, scene, roi, mode);
    return likely(found) < kManyFound ? found
                                      : search_views(object, scene, roi, SearchMode::kThorough);
  }
  if (object.views.size() == 1) return search_views(object, scene, roi, mode);
  // An instance fits one of several views best, so all views are searched thoroughly only if the
  // quick search finds nothing.
  const auto found = search_views(object, scene, roi, SearchMode::kQuick);
  return likely(found) > 0 ? found : search_views(object, scene, roi, mode);
}

}  // namespace mbncc::search
