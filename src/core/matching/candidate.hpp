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

/// Sorts and keeps the best `most`, less those that are more than `behind` the best.
void keep_hopeful(std::vector<Candidate>& candidates, std::size_t most, double behind);

/// Drops those below `floor` from sorted candidates.
void drop_below(double floor, std::vector<Candidate>& candidates);

/// The best of different places, of sorted candidates of one level: at most `most`, and at least
/// `apart` [px at level] from each other.
std::vector<Candidate> best_places(const std::vector<Candidate>& candidates, double apart,
                                   std::size_t most);

}  // namespace mbncc
