// SPDX-License-Identifier: BSD-3-Clause
// A candidate pose, and non-maximum suppression of candidates.
#pragma once

#include <limits>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc::templates {

struct Candidate {
  Pose2D pose;       ///< of the anchor [px of `level`], rotation against the learning image
  int level = 0;     ///< of the pyramid
  double value = 0;  ///< ranking value; larger is better
};

/// Radius within which candidates are the same pose.
struct DuplicateRadius {
  double distance;   ///< [px at level] less than this apart in place, and by the arc at `rim`
  double rim;        ///< [px at level] from the anchor
  int symmetry = 1;  ///< of the object, see measure_symmetry()
};

/// Pruning of candidates.
struct Suppression {
  static constexpr double kUnlimited = std::numeric_limits<double>::infinity();

  std::size_t most;            ///< in all, ...
  double behind = kUnlimited;  ///< ... and at most this much behind the best; ...
  double apart = kUnlimited;   ///< ... except the best of a likely place that is this far [px at
                               ///< level] from others, which may be another instance
  DuplicateRadius alike = {0, 0};  ///< of duplicates the better one stays
};

/// Sorts by value, best first.
void sort_by_value(std::vector<Candidate>& candidates);

/// Non-maximum suppression. Sorts, best first.
void suppress(std::vector<Candidate>& candidates, const Suppression& suppression);

/// Drops those below `floor` from sorted candidates.
void drop_below(double floor, std::vector<Candidate>& candidates);

}  // namespace mbncc::templates
