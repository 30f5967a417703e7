// SPDX-License-Identifier: BSD-3-Clause
// Handles Ctrl-C, so that clients get a result before ROS closes the connections.
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace mbncc::nodelets {

/// Replaces roscpp's SIGINT handler while at least one instance exists.
class InterruptWatch {
 public:
  /// `on_interrupt` is called on a separate thread. When all watches of the process have called
  /// their callbacks, ROS shuts down as usual.
  explicit InterruptWatch(std::function<void()> on_interrupt);

  /// The last instance restores roscpp's handler.
  ~InterruptWatch();

 private:
  void watch();

  const std::function<void()> on_interrupt_;
  std::atomic<bool> stopped_{false};
  std::thread watcher_;
};

}  // namespace mbncc::nodelets
