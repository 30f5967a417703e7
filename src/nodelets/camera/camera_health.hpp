// SPDX-License-Identifier: BSD-3-Clause
// State and counters of a camera for its diagnostics. Thread-safe.
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace mbncc::nodelets {

class CameraHealth {
 public:
  struct Counts {
    std::uint64_t published = 0;
    std::uint64_t unreadable = 0;
    std::uint64_t frozen = 0;
    std::uint64_t unstamped = 0;  ///< grabbed while the clock did not advance
    std::uint64_t failures = 0;   ///< number of times the source failed
  };

  /// `level` as in diagnostic_msgs/DiagnosticStatus.
  void set_state(std::uint8_t level, const std::string& state);

  void count(std::uint64_t Counts::*what);

  /// Fills in the state, the counts and the rate of published images since the last call.
  void describe(diagnostic_updater::DiagnosticStatusWrapper& status);

 private:
  using Clock = std::chrono::steady_clock;

  std::mutex mutex_;
  std::uint8_t level_ = diagnostic_msgs::DiagnosticStatus::WARN;
  std::string state_ = "not opened yet";
  Counts counts_;
  std::uint64_t published_before_ = 0;
  Clock::time_point described_at_ = Clock::now();
};

}  // namespace mbncc::nodelets
