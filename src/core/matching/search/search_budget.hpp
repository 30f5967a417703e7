// SPDX-License-Identifier: BSD-3-Clause
// How much is done for an object in a picture.
#pragma once

#include <cstddef>

namespace mbncc {

/// How hard the candidates are looked at.
struct SearchBudget {
  std::size_t edge_poses;  ///< of the edge search, at most
  std::size_t on_edges;    ///< of them those that lie best on edges, at most
  std::size_t judged;      ///< of them and others at a level by all evidence, at most
  std::size_t entering;    ///< candidates that enter at a level, at most
  double width;            ///< [px at level] objects narrower enter one level finer
  double narrow;           ///< [px] contours of objects narrower are followed first
  double kept;             ///< candidates at each level, times most_at()
};
constexpr SearchBudget kThorough{400, 1600, 200, 64, 3, 5, 2};
constexpr SearchBudget kFurther{100, 100, 64, 24, 3, 5, 2};

/// How hard the first look is.
struct FirstBudget {
  SearchBudget effort;
  std::size_t round_places;  ///< whose contour does not tell the rotation, at most
  int correlated_places;     ///< of the correlation, at most
  double promising;          ///< log-odds that polishing may bring to acceptance
};
constexpr FirstBudget kSparing{{100, 100, 24, 12, 0, 0, 1}, 10, 100, -5};
constexpr FirstBudget kQuick{{400, 200, 96, 48, 0, 0, 1}, 24, 100, -8};

/// Log-odds behind the best that other places do not make up for.
constexpr double kHopeless = 15;  ///< on the way down
constexpr double kNoRival = 12;   ///< at full resolution

/// Correlation is spared where of the candidates by edges
constexpr double kSure = 3;            ///< the best has at least these log-odds, ...
constexpr double kSecond = -1;         ///< any other place less than these, ...
constexpr std::size_t kForemost = 60;  ///< and the best was among so many first proposals.

/// Further instances are looked for where so many are beyond doubt.
constexpr std::size_t kSeveral = 2;

/// The thorough look is spared where the best candidate has these log-odds, less the clutter.
constexpr double kFound = 3;

}  // namespace mbncc
