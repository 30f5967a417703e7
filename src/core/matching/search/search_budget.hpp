// SPDX-License-Identifier: BSD-3-Clause
// How many candidates the searches of an object in an image follow, and when they end.
#pragma once

#include <cstddef>

namespace mbncc::search {

/// The defaults are those of the first search.
struct SearchBudget {
  std::size_t contour_proposals = 400;  ///< poses of the contour search, at most
  std::size_t best_by_contour = 200;    ///< the best of these by contour, at most
  std::size_t correlated_places = 100;  ///< places of the correlation search, at most
  std::size_t judged = 96;    ///< candidates scored by all features at the first level, at most
  std::size_t entering = 48;  ///< the best of these, which are aligned there, at most
  std::size_t kept = 1;       ///< candidates at each level, times most_at()
  double promising = -8;      ///< least log-odds for multi-start alignment
};

/// Each further search, because the first may have missed instances.
constexpr SearchBudget kFurtherSearch = [] {
  SearchBudget budget;
  budget.contour_proposals = budget.best_by_contour = 200;
  budget.judged = 100;
  budget.entering = 64;
  budget.kept = 2;
  return budget;
}();

/// The first search of one object among many.
constexpr SearchBudget kReducedSearch = [] {
  SearchBudget budget;
  budget.contour_proposals = budget.best_by_contour = 100;
  budget.judged = 24;
  budget.entering = 12;
  budget.promising = -5;
  return budget;
}();

/// Log-odds behind the best below which candidates are dropped.
constexpr double kPruningMargin = 15;       ///< while tracking down the pyramid
constexpr double kFinalPruningMargin = 12;  ///< among candidates at full resolution

/// Correlation is skipped if, of the contour candidates,
constexpr double kMinBestOdds = 3;     ///< the best has at least these log-odds, ...
constexpr double kMaxSecondOdds = -1;  ///< every other place has less than these, ...
constexpr std::size_t kForemost = 60;  ///< and the best was among this many first proposals.

/// The object is searched again unless the best candidate has these log-odds after the clutter
/// penalty, ...
constexpr double kMinFoundOdds = 3;
/// ... and fewer places than this have them, because the candidates of many instances may use up
/// the budget.
constexpr std::size_t kManyFound = 4;

}  // namespace mbncc::search
