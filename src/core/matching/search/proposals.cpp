// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/proposals.hpp"

#include <algorithm>

#include "imaging/pyramid.hpp"
#include "matching/proposal/contour_search.hpp"
#include "matching/proposal/ncc_search.hpp"
#include "matching/search/candidate_odds.hpp"
#include "matching/search/colour_ranking.hpp"
#include "matching/search/search_budget.hpp"

namespace mbncc::search {
namespace {

constexpr std::size_t kRanked = 8000;  // contour proposals that are ranked by colours

cv::Rect at_level(const cv::Rect& roi, int level) {
  const int side = 1 << level;
  const cv::Point low(roi.x / side, roi.y / side);
  const cv::Point high((roi.br().x + side - 1) / side, (roi.br().y + side - 1) / side);
  return {low, high};
}

}  // namespace

void Proposals::follow_edges(std::size_t most, std::size_t round_places) {
  const int level = view_.edges.level();
  proposal::EdgeCandidates found = proposal::edge_search(
      view_.edges, scene_.levels[level], at_level(roi_, level), most, most, view_.sector, places_);
  edges_ = std::move(found.poses);
  for (auto& place : found.round_places)
    place.value = candidate_odds(view_, scene_, level, place.pose);
  templates::suppress(found.round_places, {round_places, kHopeless});
  for (const auto& place : found.round_places) add_rotations_by_surface(place);
}

/// The best rotations at a place by the surface.
void Proposals::add_rotations_by_surface(const templates::Candidate& place) {
  constexpr std::size_t kMost = 4;
  auto peaks = rotation_peaks(view_.rough[place.level], scene_.levels[place.level], place, 1.5);
  peaks.erase(std::remove_if(peaks.begin(), peaks.end(),
                             [this](const templates::Candidate& peak) {
                               return !view_.sector.contains(peak.pose.theta);
                             }),
              peaks.end());
  if (peaks.size() > kMost) peaks.resize(kMost);
  round_.insert(round_.end(), peaks.begin(), peaks.end());
}

std::vector<templates::Candidate> Proposals::by_correlation(int most) const {
  const int level = view_.kernels.level;
  if (!view_.kernels.searched()) return {};  // only contours are used
  proposal::CoarseSettings settings;
  settings.max_places = most;
  const cv::Rect inside = at_level(roi_, level) & cv::Rect({0, 0}, scene_.grey[level].size());
  return proposal::coarse_search(view_.kernels, *scene_.padded(level, view_.kernels.radius + 1),
                                 inside, settings, view_.sector, places_);
}

bool Proposals::foremost_by_edges(const Pose2D& pose, std::size_t count) const {
  constexpr double kNear = 2.5;  // [px at the edges' level]
  const cv::Point2d place = imaging::to_level(pose.position(), view_.edges.level());
  const auto end = edges_.begin() + static_cast<std::ptrdiff_t>(std::min(count, edges_.size()));
  return std::any_of(edges_.begin(), end, [&](const templates::Candidate& proposed) {
    return cv::norm(proposed.pose.position() - place) < kNear;
  });
}

std::vector<templates::Candidate> Proposals::by_edges(std::size_t most) const {
  const auto count = static_cast<std::ptrdiff_t>(std::min(most, edges_.size()));
  std::vector<templates::Candidate> proposed(edges_.begin(), edges_.begin() + count);
  proposed.insert(proposed.end(), round_.begin(), round_.end());
  return proposed;
}

std::vector<templates::Candidate> Proposals::by_visible_part(std::size_t most) const {
  const int level = view_.edges.level();
  const proposal::EdgeCandidates found =
      proposal::edge_search(view_.edges, scene_.levels[level], at_level(roi_, level), 0, kRanked,
                            view_.sector, places_, proposal::OutlinePart::kThreeQuarters);
  return best_by_colours(view_, scene_, found.poses, most);
}

}  // namespace mbncc::search
