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

}  // namespace

const std::vector<templates::Candidate>& Proposals::by_contour(std::size_t most) {
  const int level = view_.contour_bank.level();
  by_contour_ = proposal::contour_search(view_.contour_bank, scene_.levels[level],
                                         imaging::to_level(roi_, level), most, places_);
  return by_contour_;
}

std::vector<templates::Candidate> Proposals::by_correlation(std::size_t most) const {
  const int level = view_.template_bank.level;
  if (!view_.template_bank.searched()) return {};  // only contours are used
  const cv::Rect inside =
      imaging::to_level(roi_, level) & cv::Rect({0, 0}, scene_.grey[level].size());
  return proposal::coarse_search(
      view_.template_bank, *scene_.padded(level, view_.template_bank.radius + 1), inside, most);
}

bool Proposals::foremost_by_contour(const Pose2D& pose, std::size_t count) const {
  constexpr double kNear = 2.5;  // [px at the contour's level]
  const cv::Point2d place = imaging::to_level(pose.position(), view_.contour_bank.level());
  const auto end =
      by_contour_.begin() + static_cast<std::ptrdiff_t>(std::min(count, by_contour_.size()));
  return std::any_of(by_contour_.begin(), end, [&](const templates::Candidate& proposed) {
    return cv::norm(proposed.pose.position() - place) < kNear;
  });
}

void Proposals::search_partial_contours() {
  const int level = view_.contour_bank.level();
  next_ = 0;
  partial_ =
      ranked_by_colours(view_, scene_,
                        proposal::contour_search(view_.contour_bank, scene_.levels[level],
                                                 imaging::to_level(roi_, level), kRanked, places_,
                                                 proposal::OutlinePart::kThreeQuarters));
}

std::vector<templates::Candidate> Proposals::next_by_partial_contour(
    std::size_t most, const std::vector<templates::Candidate>& known, double near) {
  std::vector<templates::Candidate> others;
  for (; others.size() < most && next_ < partial_.size(); ++next_) {
    const templates::Candidate& proposed = partial_[next_];
    const cv::Point2d place = imaging::from_level(proposed.pose, proposed.level).position();
    if (!templates::is_near(place, known, near)) others.push_back(proposed);
  }
  return others;
}

}  // namespace mbncc::search
