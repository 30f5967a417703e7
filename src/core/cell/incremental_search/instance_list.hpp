// SPDX-License-Identifier: BSD-3-Clause
// The known instances in a video.
#pragma once

#include <algorithm>
#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/match.hpp"

namespace mbncc::incremental_search {

struct Known {
  /// From the last search at its place; its competitors are those of the same object nearby.
  Match match;
  /// The last search of the whole image for this object has compared it with other places.
  bool compared_elsewhere = false;
  std::optional<Competitor> elsewhere;  ///< the best of them
  /// By name, the objects searched at its place since its pixels changed, with the best one found
  /// there; a missing name is still to be searched.
  std::map<std::string, std::optional<Competitor>> others;
  bool in_motion = false;  ///< its pixels differed from the reference and were not at rest
  int looks = 1;           ///< searches since its pixels changed last

  cv::Rect box() const;  ///< [px] bounding box of its outline

  /// It was searched again on the same pixels; the comparisons of `before` stay valid, and a change
  /// of light since then does not count in its favour.
  void take_comparisons(const Known& before);

  /// The match with its known competitors. Graspable only if it was compared with all of `names`.
  Match judged(const std::vector<std::string>& names, const SearchConfig& config) const;
};

/// As a competitor of others.
Rival rival_of(const Match& match);

/// Overlap of the outlines' areas as part of the smaller one [0..1].
double outline_overlap(const std::vector<cv::Point2f>& a, const std::vector<cv::Point2f>& b);

/// Of the same object and near enough to be the same instance, `reach` [px] apart at most.
bool is_continued(const Match& before, const Match& now, double reach);

/// The continued one nearest to `now`; null: none.
const Known* predecessor(const std::vector<Known>& before, const Match& now, double reach);

class InstanceList {
 public:
  /// Outlines may overlap by this part of the smaller one [0..1].
  explicit InstanceList(double max_overlap) : max_overlap_(max_overlap) {}

  std::vector<Known>& all() { return known_; }
  const std::vector<Known>& all() const { return known_; }

  bool shows(const std::string& name) const;

  /// Removes those for which `leaves` holds.
  template <class Predicate>
  std::vector<Known> take(const Predicate& leaves) {
    const auto begin = std::stable_partition(known_.begin(), known_.end(),
                                             [&](const Known& one) { return !leaves(one); });
    const std::vector<Known> taken(begin, known_.end());
    known_.erase(begin, known_.end());
    return taken;
  }

  /// Adds an instance and replaces weaker ones there, which become its competitors, or itself
  /// within `reach` [px]. Null if a better one is there. Valid until the next change.
  Known* admit(Known found, double reach);

  /// Compares all instances with what a search of the object `name` found. `is_covered(box)`: all
  /// of its poses that touch the box [px] were searched.
  template <class Covered>
  void compare(const std::string& name, const std::vector<Rival>& found,
               const Covered& is_covered) {
    for (auto& known : known_) {
      if (known.match.name != name && is_covered(known.box())) known.others.try_emplace(name);
      for (const auto& rival : found)
        if (rival.name == name) compare(known, rival);
    }
  }

 private:
  void compare(Known& known, const Rival& rival) const;
  bool is_explained(const Rival& rival) const;

  double max_overlap_;
  std::vector<Known> known_;
};

}  // namespace mbncc::incremental_search
