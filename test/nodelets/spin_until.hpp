// SPDX-License-Identifier: BSD-3-Clause
// Waiting in rostests: for a predicate, never for a fixed time.
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <chrono>

namespace mbncc::nodelets {

/// Handles callbacks until `predicate` holds. Returns false if it does not hold within `timeout`, a
/// generous deadline on the steady clock.
template <class Predicate>
bool spin_until(Predicate predicate, std::chrono::seconds timeout = std::chrono::seconds(30)) {
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  while (ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
    if (predicate()) return true;
    if (std::chrono::steady_clock::now() > deadline) return false;
  }
  return false;
}

}  // namespace mbncc::nodelets
