// SPDX-License-Identifier: BSD-3-Clause
// Regions still to be searched, for each object.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace mbncc::incremental_search {

class PendingRegions {
 public:
  struct Pending {
    std::string name;
    cv::Rect region;  ///< [px]
  };

  /// Objects with a smaller number are more urgent.
  using Urgency = std::function<int(const std::string& name)>;

  /// Adds `region` [px] to be searched for the object. Joined with its pending regions nearby.
  void add(const std::string& name, const cv::Rect& region);

  /// `region`, as told by next(), has been searched for the object.
  void complete(const std::string& name, const cv::Rect& region);

  /// The object owes nothing any more.
  void forget(const std::string& name);

  /// That of the most urgent object, among equals the one that waits longest.
  std::optional<Pending> next(const Urgency& urgency) const;

  bool contains(const std::string& name) const;

  /// Some object has still to be searched for within `region` [px].
  bool is_open(const cv::Rect& region) const;

 private:
  std::vector<Pending> pending_;  // oldest first
};

}  // namespace mbncc::incremental_search
