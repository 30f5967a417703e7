// SPDX-License-Identifier: BSD-3-Clause
// The ROS master forgets everything when it is restarted. This process then tells it anew.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace mbncc::nodelets {

/// Asks the master every second whether it knows this process, and registers all its topics and
/// services again when it does not. Parameters are not brought back: nodelets keep what they read.
class MasterWatch {
 public:
  /// The process's one; it lives as long as somebody holds it.
  static std::shared_ptr<MasterWatch> shared();

  MasterWatch();
  ~MasterWatch();

 private:
  void watch();
  bool wait();

  std::vector<std::string> services_;  // of this process, as the master knew them
  std::string service_uri_;
  std::mutex mutex_;  // guards stopped_
  std::condition_variable changed_;
  bool stopped_ = false;
  std::thread watcher_;
};

}  // namespace mbncc::nodelets
