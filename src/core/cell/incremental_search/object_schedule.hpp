// SPDX-License-Identifier: BSD-3-Clause
// The objects searched in a video, and their state.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mbncc/object_model.hpp"

namespace mbncc::incremental_search {

struct Sought {
  static constexpr double kNever = -1e18;  ///< [s] before any stamp

  std::shared_ptr<const ObjectModel> model;
  double radius = 0;         ///< [px] of the map about the reference point
  double swept_at = kNever;  ///< [s] searched for in the whole image
  bool urgent = true;        ///< to be searched everywhere at once
  bool lost = false;         ///< an instance has gone missing

  /// [px] that an instance may move between two images.
  double reach() const;
};

class ObjectSchedule {
 public:
  /// `names`: as in SearchRequest.
  explicit ObjectSchedule(std::vector<std::string> names) : asked_(std::move(names)) {}

  /// Updates the objects from a matcher. Returns the names of those that have changed.
  std::vector<std::string> update(std::vector<std::shared_ptr<const ObjectModel>> models);

  const std::map<std::string, Sought>& all() const { return sought_; }
  std::vector<std::string> names() const;
  Sought& at(const std::string& name) { return sought_.at(name); }
  const Sought& at(const std::string& name) const { return sought_.at(name); }

  /// [px] of the largest.
  double radius(const std::vector<std::string>& names) const;

  /// Urgent ones first, then the one not searched for longest; "": none.
  std::string next_to_sweep() const;

  /// Requested objects that cannot be searched.
  std::vector<std::string> unavailable() const;

 private:
  bool is_wanted(const ObjectModel& model) const;

  std::vector<std::string> asked_;
  std::vector<std::shared_ptr<const ObjectModel>> models_;
  std::map<std::string, Sought> sought_;
};

}  // namespace mbncc::incremental_search
