// SPDX-License-Identifier: BSD-3-Clause
#include "matching/suppression.hpp"

#include <algorithm>

namespace mbncc::bench {

std::vector<Found> without_neighbours(std::vector<Found> found, double distance) {
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.score > b.score; });
  std::vector<Found> kept;
  for (const auto& one : found) {
    const bool near = std::any_of(kept.begin(), kept.end(), [&](const Found& better) {
      return cv::norm(better.pose.position() - one.pose.position()) < distance;
    });
    if (!near) kept.push_back(one);
  }
  return kept;
}

}  // namespace mbncc::bench
