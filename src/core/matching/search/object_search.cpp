// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/object_search.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

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

bool reference_within(const decision::Detection& detection, const cv::Rect& roi) {
  if (roi.empty()) return true;
  const Pose2D pose = compose(detection.pose, detection.view->reference_in_anchor);
  return pose.x >= roi.x && pose.y >= roi.y && pose.x <= roi.br().x - 1 && pose.y <= roi.br().y - 1;
}

std::vector<decision::Detection> search_views(const prepared::PreparedObject& object,
                                              const scene::SceneImage& scene, const cv::Rect& roi,
                                              SearchMode mode) {
  const bool gated = mode == SearchMode::kGated;
  std::vector<decision::Detection> found;
  for (const auto& view : object.views) {
    const auto detections =
        search_view(object, view, scene, anchor_region(roi, view, scene.size()), mode,
                    gated ? view.colour_prefilter.places(scene.classes()) : proposal::SearchMask{});
    std::copy_if(
        detections.begin(), detections.end(), std::back_inserter(found),
        [&](const decision::Detection& detection) { return reference_within(detection, roi); });
  }
  return object.views.size() > 1 ? decision::resolve_rotations(std::move(found)) : found;
}

/// Whether nothing else resembles the object.
bool is_alike(const prepared::PreparedView& view, const Footprint& other) {
  constexpr double kRadius = 0.15, kArea = 0.25;  // ln of the ratios
  return std::abs(std::log(other.circle.radius / view.shape.radius())) < kRadius &&
         std::abs(std::log(other.area / cv::contourArea(view.outline))) < kArea;
}

}  // namespace

// An instance fits one of several views best, so the thorough search is used only if none finds it.
std::vector<decision::Detection> search_object(const prepared::PreparedObject& object,
                                               const scene::SceneImage& scene, const cv::Rect& roi,
                                               SearchMode mode) {
  if (is_sparing(mode) || object.views.size() == 1) return search_views(object, scene, roi, mode);
  const auto found = search_views(object, scene, roi, SearchMode::kQuick);
  const bool enough = std::any_of(
      found.begin(), found.end(),
      [](const decision::Detection& detection) { return detection.log_odds() >= kFound; });
  return enough ? found : search_views(object, scene, roi, mode);
}

std::vector<decision::Detection> search_occupied(const prepared::PreparedObject& object,
                                                 const scene::SceneImage& scene,
                                                 const cv::Rect& roi,
                                                 const std::vector<Footprint>& occupied,
                                                 const std::vector<decision::Detection>& found) {
  // Of the radius: detections farther away, of a neighbour that lies on top of another instance, do
  // not show that the place was compared.
  constexpr double kInPlace = 0.25;
  std::vector<decision::Detection> detections;
  for (const auto& view : object.views) {
    const auto near = [&](cv::Point2d one, cv::Point2d other) {
      return cv::norm(one - other) < kInPlace * view.shape.radius();
    };
    std::vector<cv::Point2d> centres;
    for (const auto& other : occupied) {
      const cv::Point2d centre = other.circle.centre;
      if (is_alike(view, other) &&
          std::none_of(found.begin(), found.end(),
                       [&](const auto& one) { return near(one.pose.position(), centre); }) &&
          std::none_of(centres.begin(), centres.end(),
                       [&](const auto& known) { return near(known, centre); }))
        centres.push_back(centre);
    }
    if (view.polar || centres.empty()) continue;
    const auto judged = judge_places(object, view, scene, centres);
    std::copy_if(judged.begin(), judged.end(), std::back_inserter(detections),
                 [&](const decision::Detection& one) { return reference_within(one, roi); });
  }
  return detections;
}

}  // namespace mbncc::search
