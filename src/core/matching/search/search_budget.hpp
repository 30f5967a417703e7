// SPDX-License-Identifier: BSD-3-Clause
// Search budget of an object in a picture.
#pragma once

#include <cstddef>

namespace mbncc {

/// Budget for candidates.
struct SearchBudget {
  std::size_t edge_poses;  ///< poses of the contour search, at most
  std::size_t on_edges;    ///< of them the best by contour, at most
  std::size_t judged;      ///< of them and others at a level by all features, at most
  std::size_t entering;    ///< candidates that enter at a level, at most
  double width;            ///< [px at level] objects narrower enter one level finer
  double narrow;           ///< [px] contours of narrower objects are aligned first
  int steps;               ///< of alignment before proposals are scored
  double kept;             ///< candidates at each level, times most_at()
};
constexpr SearchBudget kThorough{200, 200, 100, 64, 3, 5, 1, 2};
constexpr SearchBudget kFurther{100, 100, 64, 24, 3, 5, 1, 2};

/// Budget of the first search.
struct FirstBudget {
  SearchBudget effort;
  std::size_t round_places;  ///< whose contour does not determine the rotation, at most
  int correlated_places;     ///< of the correlation, at most
  double promising;          ///< least log-odds for multi-start alignment
};
constexpr FirstBudget kSparing{{100, 100, 24, 12, 0, 0, 0, 1}, 10, 100, -5};
constexpr FirstBudget kQuick{{400, 200, 96, 48, 0, 0, 0, 1}, 24, 100, -8};

/// Log-odds behind the best below which candidates are dropped.
constexpr double kHopeless = 15;  ///< on the way down
constexpr double kNoRival = 12;   ///< at full resolution

/// Correlation is skipped if, of the contour candidates,
constexpr double kCertain = 3;         ///< the best has at least these log-odds, ...
constexpr double kSecond = -1;         ///< any other place less than these, ...
constexpr std::size_t kForemost = 60;  ///< and the best was among so many first proposals.

/// Further instances are searched if this many are certain.
constexpr std::size_t kSeveral = 2;

/// The thorough search is skipped if the best candidate has these log-odds, minus the clutter
/// penalty.
constexpr double kFound = 3;

}  // namespace mbncc
