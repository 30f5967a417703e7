// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/report.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "matching/decision/conclusion.hpp"
#include "matching/decision/equivalent_pose.hpp"

namespace mbncc::decision {
namespace {

/// Moves each match to an equivalent pose in `roi` if it has one, and drops the others.
void keep_within(const cv::Rect& roi, std::vector<Match>& matches) {
  for (auto& match : matches) {
    const cv::Point2d centre = match.pose.position() + match.to_symmetry_centre;
    const Pose2D pose = equivalent_within(roi, match.pose, match.symmetry, centre);
    match = equivalent_towards(pose.theta, std::move(match));
  }
  matches.erase(
      std::remove_if(matches.begin(), matches.end(),
                     [&](const Match& match) { return !contains(roi, match.pose.position()); }),
      matches.end());
}

}  // namespace

std::vector<Match> reported(std::vector<Match> matches, const cv::Rect& roi, int most,
                            const SearchConfig& config) {
  keep_within(roi, matches);
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& a, const Match& b) { return a.score > b.score; });
  std::map<std::string, int> count;
  std::vector<Match> kept;
  for (auto& match : matches) {
    if (++count[match.name] <= most) {
      kept.push_back(std::move(match));
      continue;
    }
    for (auto& better : kept) {
      if (better.name != match.name) continue;
      const double odds = better.odds.of_competitor(match.odds, true) + better.odds.calibration;
      better.competitors.push_back({match.name, match.pose.position(), odds});
      conclude(better, config);
    }
  }
  return kept;
}

}  // namespace mbncc::decision
