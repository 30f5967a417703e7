// The instances that a watched picture is known to show.
#pragma once

#include <algorithm>
#include <limits>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/matching/matcher.hpp"

namespace mbncc {

struct Known {
  Match match;
  /// Margins of the last search of the whole picture for this object, and of the searches for other
  /// objects at this place; none yet: no margin at all, and no competitor.
  double margin_elsewhere = -std::numeric_limits<double>::infinity();
  double margin_to_others = std::numeric_limits<double>::infinity();
  int looks = 1;  ///< searches since its pixels changed last

  cv::Rect box() const;  ///< [px] about its outline

  /// It has been compared with the whole picture.
  bool is_compared() const;

  /// The match with all that is known about its competitors; graspable and ambiguous for
  /// `config`, as if no search were owed.
  Match judged(const SearchConfig& config) const;
};

/// Overlap of the outlines' areas as part of the smaller one [0..1].
double outline_overlap(const std::vector<cv::Point2f>& a, const std::vector<cv::Point2f>& b);

/// Of the same object and near enough to be the same instance, `reach` [px] apart at most.
bool is_continued(const Match& before, const Match& now, double reach);

/// The continued one nearest to `now`; null: none.
const Known* predecessor(const std::vector<Known>& before, const Match& now, double reach);

class KnownInstances {
 public:
  /// Outlines may overlap by this part of the smaller one [0..1].
  explicit KnownInstances(double max_overlap) : max_overlap_(max_overlap) {}

  std::vector<Known>& all() { return known_; }
  const std::vector<Known>& all() const { return known_; }

  bool shows(const std::string& name) const;

  /// Takes out those for which `leaves` holds.
  template <class Predicate>
  std::vector<Known> take(const Predicate& leaves) {
    const auto begin = std::stable_partition(known_.begin(), known_.end(),
                                             [&](const Known& one) { return !leaves(one); });
    const std::vector<Known> taken(begin, known_.end());
    known_.erase(begin, known_.end());
    return taken;
  }

  /// Adds an instance in place of weaker ones there, or of itself within `reach` [px]. Null when a
  /// better one lies there. Valid until the next change.
  Known* admit(Known found, double reach);

  /// Instances of other objects lose margin to what was found at their places.
  void note_rivals(const std::vector<Rival>& rivals);

 private:
  void note_rival(const Rival& rival);

  double max_overlap_;
  std::vector<Known> known_;
};

}  // namespace mbncc
