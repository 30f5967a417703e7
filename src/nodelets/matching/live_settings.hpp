// SPDX-License-Identifier: BSD-3-Clause
// The matching nodelet's settings, some of which may change at run time.
#pragma once

#include <mutex>

#include "mbncc/config/matching_node_config.hpp"

namespace mbncc::nodelets {

class LiveSettings {
 public:
  explicit LiveSettings(const MatchingNodeConfig& config) : initial_(config), current_(config) {}

  /// The settings with which the nodelet was started.
  const MatchingNodeConfig& initial() const { return initial_; }

  MatchingNodeConfig get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return current_;
  }

  /// Calls `change` with the settings under exclusive access.
  template <class Change>
  auto change(const Change& change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return change(current_);
  }

 private:
  const MatchingNodeConfig initial_;
  mutable std::mutex mutex_;
  MatchingNodeConfig current_;
};

}  // namespace mbncc::nodelets
