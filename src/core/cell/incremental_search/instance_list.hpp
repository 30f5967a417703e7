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

struct Instance {
  /// Result of the last search at this place; its competitors are only those of the same object
  /// nearby, and instances of others that it replaced in this image.
  Match match;
  /// Whether the last search of the whole image for this object has compared it with other places.
  bool compared_elsewhere = false;
  std::optional<Competitor> elsewhere;  ///< the best competitor of the same object at another place
  /// By name, the objects searched for at this place since its pixels changed, each with its best
  /// competitor found there; a name that is missing must still be searched for.
  std::map<std::string, std::optional<Competitor>> others;
  bool in_motion = false;  ///< its pixels differed from the reference and were not at rest
  int searches = 1;        ///< searches since its pixels changed last
  double searched_at = 0;  ///< [s] stamp of its last search

  cv::Rect box() const;  ///< [px] bounding box of its outline

  /// Takes over the comparisons of `before`, the same instance in an earlier search of the same
  /// pixels. Its competitors' log-odds change with its own, so a change of light does not count in
  /// its favour.
  void inherit_comparisons(const Instance& before);

  /// The match with its known competitors. Graspable only if it was compared with all of `names`.
  Match judged(const std::vector<std::string>& names, const SearchConfig& config) const;
};

/// The match as a rival of other instances.
Rival rival_of(const Match& match);

/// Overlap of the outlines' areas as a part [0..1] of the smaller area.
double outline_overlap(const std::vector<cv::Point2f>& a, const std::vector<cv::Point2f>& b);

/// Whether both are of the same object and near enough to be the same instance, at most `reach`
/// [px] apart.
bool is_continued(const Match& before, const Match& now, double reach);

/// The nearest instance of `before` that `now` continues (is_continued()); null if there is none.
const Instance* predecessor(const std::vector<Instance>& before, const Match& now, double reach);

class InstanceList {
 public:
  /// `max_overlap` is the part [0..1] of the smaller outline by which outlines may overlap.
  explicit InstanceList(double max_overlap) : max_overlap_(max_overlap) {}

  std::vector<Instance>& all() { return instances_; }
  const std::vector<Instance>& all() const { return instances_; }

  bool shows(const std::string& name) const;

  /// Removes and returns the instances for which `leaves` holds.
  template <class Predicate>
  std::vector<Instance> take(const Predicate& leaves) {
    const auto begin = std::stable_partition(instances_.begin(), instances_.end(),
                                             [&](const Instance& one) { return !leaves(one); });
    const std::vector<Instance> taken(begin, instances_.end());
    instances_.erase(begin, instances_.end());
    return taken;
  }

  /// Adds an instance and removes those it overlaps: others with lower scores, with whose objects
  /// it must be compared again, and its own earlier state within `reach` [px]. Null if a better
  /// instance is there. The pointer is valid until the next change of the list.
  Instance* admit(Instance found, double reach);

  /// Compares all instances with the result `found` of a search for object `name`.
  /// `is_covered(box)` tells whether all poses of that object that touch `box` [px] were searched.
  template <class Covered>
  void compare(const std::string& name, const std::vector<Rival>& found,
               const Covered& is_covered) {
    for (auto& instance : instances_) {
      if (instance.match.name != name && is_covered(instance.box()))
        instance.others.try_emplace(name);
      for (const auto& rival : found)
        if (rival.name == name) compare(instance, rival);
    }
  }

 private:
  void compare(Instance& instance, const Rival& rival) const;
  bool is_explained(const Rival& rival) const;

  double max_overlap_;
  std::vector<Instance> instances_;
};

}  // namespace mbncc::incremental_search
