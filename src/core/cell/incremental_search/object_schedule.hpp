// SPDX-License-Identifier: BSD-3-Clause
// The objects that are searched for in a video, and what is still owed to them.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mbncc/object_model.hpp"

namespace mbncc {

struct Sought {
  static constexpr double kNever = -1e18;  ///< [s] before any stamp

  std::shared_ptr<const ObjectModel> model;
  double radius = 0;         ///< [px] of the map about the reference point
  double swept_at = kNever;  ///< [s] searched for in the whole picture
  bool urgent = true;        ///< to be swept at once
  bool lost = false;         ///< an instance has gone missing

  /// [px] that an instance may move between two pictures.
  double reach() const;
};

class ObjectSchedule {
 public:
  /// `names`: as in SearchRequest.
  explicit ObjectSchedule(std::vector<std::string> names) : asked_(std::move(names)) {}

  /// Takes over the objects of a matcher. Returns the names of those that are no longer what they
  /// were.
  std::vector<std::string> update(std::vector<std::shared_ptr<const ObjectModel>> models);

  const std::map<std::string, Sought>& all() const { return sought_; }
  std::vector<std::string> names() const;
  Sought& at(const std::string& name) { return sought_.at(name); }
  const Sought& at(const std::string& name) const { return sought_.at(name); }

  /// [px] of the largest.
  double radius(const std::vector<std::string>& names) const;

  /// The urgent before the others, the longest not swept first; "": there are none.
  std::string next_to_sweep() const;

  /// Those asked for that cannot be searched for.
  std::vector<std::string> unavailable() const;

 private:
  bool is_wanted(const ObjectModel& model) const;

  std::vector<std::string> asked_;
  std::vector<std::shared_ptr<const ObjectModel>> models_;
  std::map<std::string, Sought> sought_;
};

}  // namespace mbncc
