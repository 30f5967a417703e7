// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/occupied_search.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "matching/search/pose_hypothesis.hpp"
#include "matching/search/rotations.hpp"
#include "matching/search/search_budget.hpp"
#include "matching/search/verification.hpp"

namespace mbncc::search {
namespace {

/// Whether `other` has about the radius and area of the view.
bool is_alike(const prepared::PreparedView& view, const Footprint& other) {
  constexpr double kRadius = 0.15, kArea = 0.25;  // ln of the ratios
  return std::abs(std::log(other.circle.radius / view.shape.radius())) < kRadius &&
         std::abs(std::log(other.area / cv::contourArea(view.outline))) < kArea;
}

}  // namespace

std::vector<decision::Detection> search_occupied(const prepared::PreparedObject& object,
                                                 const scene::SceneImage& scene,
                                                 const std::vector<Footprint>& occupied,
                                                 const std::vector<decision::Detection>& found) {
  // [radii] A detection farther away does not show that the place was compared: it may be of a
  // neighbour that lies on top of another instance.
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
    const auto judged = search_places(object, view, scene, centres);
    detections.insert(detections.end(), judged.begin(), judged.end());
  }
  return detections;
}

std::vector<decision::Detection> search_places(const prepared::PreparedObject& object,
                                               const prepared::PreparedView& view,
                                               const scene::SceneImage& scene,
                                               const std::vector<cv::Point2d>& centres) {
  std::vector<templates::Candidate> candidates;
  for (const auto& centre : centres) {
    const auto turned = rotations_at(view, scene, {{centre.x, centre.y, 0}, 0, 0});
    candidates.insert(candidates.end(), turned.begin(), turned.end());
  }
  templates::sort_by_value(candidates);
  templates::drop_below(kMinOddsToRefine, candidates);
  if (candidates.empty()) return {};
  return verify(object, view, scene, hypotheses(view, scene, candidates, SearchBudget().promising));
}

}  // namespace mbncc::search
