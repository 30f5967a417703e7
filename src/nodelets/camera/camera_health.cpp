// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/camera/camera_health.hpp"

namespace mbncc::nodelets {

void CameraHealth::set_state(std::uint8_t level, const std::string& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  level_ = level;
  state_ = state;
}

void CameraHealth::count(std::uint64_t Counts::*what) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++(counts_.*what);
}

void CameraHealth::describe(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Clock::time_point now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - described_at_).count();
  const double rate = static_cast<double>(counts_.published - published_before_) / elapsed;
  described_at_ = now;
  published_before_ = counts_.published;
  status.summary(level_, state_);
  status.addf("rate [Hz]", "%.2f", rate);
  status.add("published", counts_.published);
  status.add("unreadable images", counts_.unreadable);
  status.add("frozen images", counts_.frozen);
  status.add("images without a new stamp", counts_.unstamped);
  status.add("failures of the source", counts_.failures);
}

}  // namespace mbncc::nodelets
