#include "matching/candidate.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc {

void sort_by_value(std::vector<Candidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.value > b.value; });
}

void drop_duplicates(std::vector<Candidate>& candidates, double distance, double rim,
                     std::size_t most) {
  sort_by_value(candidates);
  std::vector<Candidate> kept;
  for (const auto& candidate : candidates) {
    const auto same = [&](const Candidate& other) {
      return std::abs(candidate.pose.x - other.pose.x) < distance &&
             std::abs(candidate.pose.y - other.pose.y) < distance &&
             angle_distance(candidate.pose.theta, other.pose.theta) * rim < 1.5 * distance;
    };
    if (std::any_of(kept.begin(), kept.end(), same)) continue;
    kept.push_back(candidate);
    if (kept.size() == most) break;
  }
  candidates = std::move(kept);
}

}  // namespace mbncc
