// SPDX-License-Identifier: BSD-3-Clause
// The objects searched for in a video, and the state of their searches.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mbncc/object_model.hpp"

namespace mbncc::incremental_search {

struct SearchedObject {
  static constexpr double kNever = -1e18;  ///< [s] before any stamp

  std::shared_ptr<const ObjectModel> model;
  double radius = 0;         ///< [px] of the maps about the reference point
  double overhang = 0;       ///< [px] largest distance of the reference point from a change
  double swept_at = kNever;  ///< [s] last search of the whole image for the object
  bool urgent = true;        ///< the whole image must be searched for it at once
  bool lost = false;         ///< an instance has gone missing

  /// Largest motion [px] of an instance between two images.
  double reach() const;
};

class ObjectSchedule {
 public:
  /// `names`: as in SearchRequest.
  explicit ObjectSchedule(std::vector<std::string> names) : requested_(std::move(names)) {}

  /// Updates the objects from a matcher; `unsearchable`: names and reasons of those that are left
  /// out. Returns the names of those that have changed or are no longer searched for.
  std::vector<std::string> update(std::vector<std::shared_ptr<const ObjectModel>> models,
                                  std::map<std::string, std::string> unsearchable);

  const std::map<std::string, SearchedObject>& all() const { return objects_; }
  std::vector<std::string> names() const;
  SearchedObject& at(const std::string& name) { return objects_.at(name); }
  const SearchedObject& at(const std::string& name) const { return objects_.at(name); }

  /// Radius [px] of the largest of these objects.
  double radius(const std::vector<std::string>& names) const;

  /// The object whose last search of the whole image is the longest ago. There must be one.
  std::string longest_unswept() const;

  /// The same among the urgent ones; none if there is none.
  std::optional<std::string> most_urgent() const;

  double largest_radius() const;  ///< [px] of all objects

  /// "name: reason" of the requested objects that cannot be searched for.
  std::vector<std::string> unavailable() const;

 private:
  bool is_requested(const std::string& name) const;

  std::vector<std::string> requested_;
  std::vector<std::shared_ptr<const ObjectModel>> models_;
  std::map<std::string, std::string> unsearchable_;
  std::map<std::string, SearchedObject> objects_;
};

}  // namespace mbncc::incremental_search
