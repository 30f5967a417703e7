// SPDX-License-Identifier: BSD-3-Clause
// Re-registers this process after a restart of the ROS master.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace mbncc::nodelets {

/// Asks the master every second whether it knows this process, and registers all its topics and
/// services again if it does not. Parameters are not restored: nodelets keep the values they have
/// read.
class MasterWatch {
 public:
  /// The shared instance of the process; it lives as long as it is referenced.
  static std::shared_ptr<MasterWatch> shared();

  MasterWatch();
  ~MasterWatch();

 private:
  void watch();
  bool wait();

  std::vector<std::string> services_;  // of this process, as last listed by the master
  std::string service_uri_;
  std::mutex mutex_;  // guards stopped_
  std::condition_variable changed_;
  bool stopped_ = false;
  std::thread watcher_;
};

}  // namespace mbncc::nodelets
