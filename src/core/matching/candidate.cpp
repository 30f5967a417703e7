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

void keep_hopeful(std::vector<Candidate>& candidates, std::size_t most, double behind) {
  sort_by_value(candidates);
  if (candidates.size() > most) candidates.resize(most);
  while (candidates.size() > 1 && candidates.back().value < candidates.front().value - behind)
    candidates.pop_back();
}

void drop_below(double floor, std::vector<Candidate>& candidates) {
  while (!candidates.empty() && candidates.back().value < floor) candidates.pop_back();
}

std::vector<Candidate> best_places(const std::vector<Candidate>& candidates, double apart,
                                   std::size_t most) {
  std::vector<Candidate> places;
  for (const auto& candidate : candidates) {
    const bool near = std::any_of(places.begin(), places.end(), [&](const Candidate& other) {
      return cv::norm(candidate.pose.position() - other.pose.position()) < apart;
    });
    if (!near) places.push_back(candidate);
    if (places.size() == most) break;
  }
  return places;
}

}  // namespace mbncc
