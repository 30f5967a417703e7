// SPDX-License-Identifier: BSD-3-Clause
// A candidate pose, and non-maximum suppression of candidates.
#pragma once

#include <limits>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc::templates {

struct Candidate {
  Pose2D pose;       ///< of the anchor [px at `level`], rotation relative to the learning image
  int level = 0;     ///< of the pyramid
  double value = 0;  ///< ranking value; larger is better
};

/// Radius within which candidates are the same pose.
struct DuplicateRadius {
  double distance;   ///< [px at level] between positions, and along the arc at `rim`
  double rim;        ///< [px at level] from the anchor
  int symmetry = 1;  ///< of the object, see measure_symmetry()
};

/// Pruning of candidates.
struct Suppression {
  static constexpr double kUnlimited = std::numeric_limits<double>::infinity();

  std::size_t most;            ///< largest number of candidates, ...
  double behind = kUnlimited;  ///< ... with values at most this much below the best; ...
  double apart = kUnlimited;   ///< ... except the best of a likely place that is this far [px at
                               ///< level] from others, which may be another instance
  DuplicateRadius alike = {0, 0};  ///< of duplicates, only the best one is kept
};

/// Whether one of `others` is nearer to `place` than `distance` [px at level].
bool is_near(cv::Point2d place, const std::vector<Candidate>& others, double distance);

/// Sorts by value, best first.
void sort_by_value(std::vector<Candidate>& candidates);

/// Sorts by value, best first, and applies non-maximum suppression.
void suppress(std::vector<Candidate>& candidates, const Suppression& suppression);

/// Keeps the best `most` candidates, best first, without duplicates.
void keep_distinct(std::vector<Candidate>& candidates, std::size_t most,
                   const DuplicateRadius& alike);

/// Drops those below `floor` from sorted candidates.
void drop_below(double floor, std::vector<Candidate>& candidates);

}  // namespace mbncc::templates
