// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/proposals.hpp"

#include <algorithm>

#include "imaging/pyramid.hpp"
#include "matching/proposal/contour_search.hpp"
#include "matching/proposal/ncc_search.hpp"
#include "matching/search/colour_ranking.hpp"

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

void Proposals::search_contours(std::size_t most) {
  const int level = view_.contour_bank.level();
  edges_ = proposal::edge_search(view_.contour_bank, scene_.levels[level], at_level(roi_, level),
                                 most, most, view_.sector, places_);
}

std::vector<templates::Candidate> Proposals::by_correlation(int most) const {
  const int level = view_.template_bank.level;
  if (!view_.template_bank.searched()) return {};  // only contours are used
  proposal::CoarseSettings settings;
  settings.max_places = most;
  const cv::Rect inside = at_level(roi_, level) & cv::Rect({0, 0}, scene_.grey[level].size());
  return proposal::coarse_search(view_.template_bank,
                                 *scene_.padded(level, view_.template_bank.radius + 1), inside,
                                 settings, view_.sector, places_);
}

bool Proposals::foremost_by_edges(const Pose2D& pose, std::size_t count) const {
  constexpr double kNear = 2.5;  // [px at the edges' level]
  const cv::Point2d place = imaging::to_level(pose.position(), view_.contour_bank.level());
  const auto end = edges_.begin() + static_cast<std::ptrdiff_t>(std::min(count, edges_.size()));
  return std::any_of(edges_.begin(), end, [&](const templates::Candidate& proposed) {
    return cv::norm(proposed.pose.position() - place) < kNear;
  });
}

std::vector<templates::Candidate> Proposals::by_edges(std::size_t most) const {
  return {edges_.begin(),
          edges_.begin() + static_cast<std::ptrdiff_t>(std::min(most, edges_.size()))};
}

void Proposals::search_partial_contours() {
  const int level = view_.contour_bank.level();
  next_ = 0;
  partial_ = ranked_by_colours(
      view_, scene_,
      proposal::edge_search(view_.contour_bank, scene_.levels[level], at_level(roi_, level), 0,
                            kRanked, view_.sector, places_, proposal::OutlinePart::kThreeQuarters));
}

std::vector<templates::Candidate> Proposals::next_by_partial_contour(
    std::size_t most, const std::vector<templates::Candidate>& known, double near) {
  std::vector<templates::Candidate> others;
  for (; others.size() < most && next_ < partial_.size(); ++next_) {
    const templates::Candidate& proposed = partial_[next_];
    const cv::Point2d place = imaging::from_level(proposed.pose, proposed.level).position();
    if (std::none_of(known.begin(), known.end(), [&](const templates::Candidate& one) {
          return cv::norm(one.pose.position() - place) < near;
        }))
      others.push_back(proposed);
  }
  return others;
}

}  // namespace mbncc::search
