// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C: something is said to the clients before ROS takes the connections down.
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace mbncc::nodelets {

/// Takes SIGINT over from roscpp while at least one of them lives.
class InterruptWatch {
 public:
  /// `on_interrupt` is called on a thread of its own. When all watches of the process have called
  /// theirs, ROS is asked to shut down as usual.
  explicit InterruptWatch(std::function<void()> on_interrupt);

  /// The last one gives SIGINT back.
  ~InterruptWatch();

 private:
  void watch();

  const std::function<void()> on_interrupt_;
  std::atomic<bool> stopped_{false};
  std::thread watcher_;
};

}  // namespace mbncc::nodelets
