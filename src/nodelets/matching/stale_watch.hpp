// SPDX-License-Identifier: BSD-3-Clause
// Detects that images have stopped, by the steady clock because a simulated one may stop.
#pragma once

#include <chrono>
#include <mutex>

namespace mbncc::nodelets {

class StaleWatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// A report is due after `stale_after` [s] without images, counted from now, and then every
  /// second.
  explicit StaleWatch(double stale_after) : stale_after_(stale_after) { restart(); }

  /// Call this when something was published or nothing is expected: the time counts from `now`.
  void restart(Clock::time_point now = Clock::now()) {
    const std::lock_guard<std::mutex> lock(mutex_);
    next_report_ = now + std::chrono::duration_cast<Clock::duration>(stale_after_);
  }

  /// True if a report is due; the next one is due a second later.
  bool due(Clock::time_point now = Clock::now()) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (now < next_report_) return false;
    next_report_ = now + std::chrono::seconds(1);
    return true;
  }

 private:
  const std::chrono::duration<double> stale_after_;
  std::mutex mutex_;
  Clock::time_point next_report_;
};

}  // namespace mbncc::nodelets
