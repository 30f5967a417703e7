#include "matching/candidate.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc {
namespace {

constexpr double kLikely = 0;  // log-odds

/// One of `others` is.
bool is_near(const Candidate& candidate, const std::vector<Candidate>& others, double distance) {
  return std::any_of(others.begin(), others.end(), [&](const Candidate& other) {
    return cv::norm(candidate.pose.position() - other.pose.position()) < distance;
  });
}

}  // namespace

bool is_further_place(const Candidate& candidate, const std::vector<Pose2D>& known, double apart) {
  return candidate.value >= kLikely &&
         std::none_of(known.begin(), known.end(), [&](const Pose2D& other) {
           return cv::norm(other.position() - candidate.pose.position()) < apart;
         });
}

void sort_by_value(std::vector<Candidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.value > b.value; });
}

void drop_duplicates(std::vector<Candidate>& candidates, const Alikeness& alike, std::size_t most,
                     double apart) {
  sort_by_value(candidates);
  std::vector<Candidate> kept;
  for (const auto& candidate : candidates) {
    if (kept.size() >= most) {
      if (candidate.value < kLikely) break;
      if (is_near(candidate, kept, apart)) continue;
    }
    const auto same = [&](const Candidate& other) {
      return std::abs(candidate.pose.x - other.pose.x) < alike.distance &&
             std::abs(candidate.pose.y - other.pose.y) < alike.distance &&
             angle_distance(candidate.pose.theta, other.pose.theta, alike.symmetry) * alike.rim <
                 1.5 * alike.distance;
    };
    if (std::any_of(kept.begin(), kept.end(), same)) continue;
    kept.push_back(candidate);
  }
  candidates = std::move(kept);
}

void keep_hopeful(std::vector<Candidate>& candidates, std::size_t most, double behind,
                  double apart) {
  sort_by_value(candidates);
  std::vector<Candidate> kept;
  for (const auto& candidate : candidates) {
    if (candidate.value < candidates.front().value - behind) break;
    const bool further = kept.size() >= most;
    if (further && candidate.value < kLikely) break;
    if (!further || !is_near(candidate, kept, apart)) kept.push_back(candidate);
  }
  candidates = std::move(kept);
}

void keep_hopeful_places(std::vector<Candidate>& candidates, std::size_t most, double behind,
                         double apart) {
  sort_by_value(candidates);
  if (candidates.size() > most) candidates.resize(most);
  std::vector<Candidate> kept;
  for (const auto& candidate : candidates) {
    const bool hopeful = candidate.value >= candidates.front().value - behind;
    if (!hopeful && candidate.value < kLikely) break;
    if (hopeful || !is_near(candidate, kept, apart)) kept.push_back(candidate);
  }
  candidates = std::move(kept);
}

void drop_below(double floor, std::vector<Candidate>& candidates) {
  while (!candidates.empty() && candidates.back().value < floor) candidates.pop_back();
}

std::vector<Candidate> best_places(const std::vector<Candidate>& candidates, double apart,
                                   std::size_t most) {
  std::vector<Candidate> places;
  for (const auto& candidate : candidates) {
    if (!is_near(candidate, places, apart)) places.push_back(candidate);
    if (places.size() == most) break;
  }
  return places;
}

}  // namespace mbncc
