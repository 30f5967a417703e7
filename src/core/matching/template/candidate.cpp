// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/candidate.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc::templates {
namespace {

constexpr double kLikely = 0;  // log-odds

bool are_alike(const Pose2D& a, const Pose2D& b, const DuplicateRadius& alike) {
  return std::abs(a.x - b.x) < alike.distance && std::abs(a.y - b.y) < alike.distance &&
         angle_distance(a.theta, b.theta, alike.symmetry) * alike.rim < 1.5 * alike.distance;
}

}  // namespace

bool is_near(cv::Point2d place, const std::vector<Candidate>& others, double distance) {
  return std::any_of(others.begin(), others.end(), [&](const Candidate& other) {
    return cv::norm(place - other.pose.position()) < distance;
  });
}

void sort_by_value(std::vector<Candidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.value > b.value; });
}

void suppress(std::vector<Candidate>& candidates, const Suppression& suppression) {
  sort_by_value(candidates);
  std::vector<Candidate> kept;
  for (const auto& candidate : candidates) {
    if (kept.size() >= suppression.most ||
        candidate.value < candidates.front().value - suppression.behind) {
      if (candidate.value < kLikely) break;
      if (is_near(candidate.pose.position(), kept, suppression.apart)) continue;
    }
    if (std::none_of(kept.begin(), kept.end(), [&](const Candidate& better) {
          return are_alike(candidate.pose, better.pose, suppression.alike);
        }))
      kept.push_back(candidate);
  }
  candidates = std::move(kept);
}

void keep_distinct(std::vector<Candidate>& candidates, std::size_t most,
                   const DuplicateRadius& alike) {
  suppress(candidates, {most, Suppression::kUnlimited, Suppression::kUnlimited, alike});
}

void drop_below(double floor, std::vector<Candidate>& candidates) {
  while (!candidates.empty() && candidates.back().value < floor) candidates.pop_back();
}

}  // namespace mbncc::templates
