// SPDX-License-Identifier: BSD-3-Clause
// What is still to be searched: places that changed, for each object.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace mbncc {

class PendingRegions {
 public:
  struct Debt {
    std::string name;
    cv::Rect region;  ///< [px]
  };

  /// Objects with a smaller number are more urgent.
  using Urgency = std::function<int(const std::string& name)>;

  /// `region` [px] is to be searched for the object. Joined with what it owes about there already.
  void owe(const std::string& name, const cv::Rect& region);

  /// `region`, as told by next(), has been searched for the object.
  void pay(const std::string& name, const cv::Rect& region);

  /// The object owes nothing any more.
  void forget(const std::string& name);

  /// That of the most urgent object, among equals the one that waits longest.
  std::optional<Debt> next(const Urgency& urgency) const;

  bool owes(const std::string& name) const;

  /// Some object has still to be searched for within `region` [px].
  bool is_open(const cv::Rect& region) const;

 private:
  std::vector<Debt> debts_;  // oldest first
};

}  // namespace mbncc
