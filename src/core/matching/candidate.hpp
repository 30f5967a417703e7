// A pose under examination.
#pragma once

#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc {

struct Candidate {
  Pose2D pose;       ///< of the anchor [px of `level`], rotation against the learning picture
  int level = 0;     ///< of the pyramid
  double value = 0;  ///< what candidates are ranked by; larger is better
};

/// Sorts by value, best first.
void sort_by_value(std::vector<Candidate>& candidates);

/// Sorts, drops what lies within `distance` [px at level] of a better one in place and, by the arc
/// at `rim` [px], in rotation, and keeps the best `most`.
void drop_duplicates(std::vector<Candidate>& candidates, double distance, double rim,
                     std::size_t most);

}  // namespace mbncc
