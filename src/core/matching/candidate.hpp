// A pose under examination.
#pragma once

#include <limits>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc {

struct Candidate {
  Pose2D pose;       ///< of the anchor [px of `level`], rotation against the learning picture
  int level = 0;     ///< of the pyramid
  double value = 0;  ///< what candidates are ranked by; larger is better
};

/// Likely by itself, and no known pose is nearer than `apart` [px at level].
bool is_further_place(const Candidate& candidate, const std::vector<Pose2D>& known, double apart);

/// Sorts by value, best first.
void sort_by_value(std::vector<Candidate>& candidates);

/// When candidates show the same pose.
struct Alikeness {
  double distance;   ///< [px at level] less than this apart in place, and by the arc at `rim`
  double rim;        ///< [px at level] from the anchor
  int symmetry = 1;  ///< of the object, see measure_symmetry()
};

/// [px at level] No place is so far from others that it is kept for being one of its own.
constexpr double kNoPlaces = std::numeric_limits<double>::infinity();

/// Sorts, drops what is alike to a better one, and keeps the best `most` and, beyond them, the best
/// of every further place that is likely by itself, `apart` from others.
void drop_duplicates(std::vector<Candidate>& candidates, const Alikeness& alike, std::size_t most,
                     double apart = kNoPlaces);

/// Sorts and keeps as many, less those that are more than `behind` the best.
void keep_hopeful(std::vector<Candidate>& candidates, std::size_t most, double behind,
                  double apart = kNoPlaces);

/// The same, but the best of a place stays where it is likely by itself: it may be a covered
/// instance, and another one lies in full view. Places are at least `apart` [px at level] from each
/// other.
void keep_hopeful_places(std::vector<Candidate>& candidates, std::size_t most, double behind,
                         double apart);

/// Drops those below `floor` from sorted candidates.
void drop_below(double floor, std::vector<Candidate>& candidates);

/// The best of different places, of sorted candidates of one level: at most `most`, and at least
/// `apart` [px at level] from each other.
std::vector<Candidate> best_places(const std::vector<Candidate>& candidates, double apart,
                                   std::size_t most);

}  // namespace mbncc
