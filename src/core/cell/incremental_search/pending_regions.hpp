// SPDX-License-Identifier: BSD-3-Clause
// Regions that must still be searched, for each object.
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

  /// Adds `region` [px] to be searched for the object. It is joined with a pending region of the
  /// object nearby.
  void add(const std::string& name, const cv::Rect& region);

  /// Removes `region`, as returned by next(), after a search of it for the object.
  void complete(const std::string& name, const cv::Rect& region);

  /// Removes all pending regions of the object.
  void forget(const std::string& name);

  /// Pending region of the most urgent object; of equally urgent ones, the one that has waited
  /// longest. None if nothing is pending.
  std::optional<Pending> next(const Urgency& urgency) const;

  bool contains(const std::string& name) const;

 private:
  std::vector<Pending> pending_;  // oldest first
};

}  // namespace mbncc::incremental_search
