// SPDX-License-Identifier: BSD-3-Clause
// Calls the services of one server one after the other on a thread of its own, so that a window
// never waits for an answer. The functions may be called from any thread, call() only within a
// function given to later().
#pragma once

#include <ros/ros.h>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <queue>
#include <string>
#include <thread>

namespace mbncc::console {

class ServiceCalls {
 public:
  ServiceCalls();
  /// Aborts the call under way; those that wait are not made.
  ~ServiceCalls();

  /// Queues a function that calls services, and returns at once.
  void later(std::function<void()> function);
  /// Whether the service answered. False as well once this is being destroyed.
  template <class Service>
  bool call(ros::NodeHandle& node, const std::string& name, Service& service);
  /// Aborts the call that waits for an answer; it fails.
  void give_up();

 private:
  bool begin(const ros::ServiceClient& client);
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::queue<std::function<void()>> functions_;
  bool stopping_ = false;
  ros::ServiceClient under_way_;
  std::thread worker_;
};

template <class Service>
bool ServiceCalls::call(ros::NodeHandle& node, const std::string& name, Service& service) {
  // Each call has its own connection, because a call that waits for its answer can only be aborted
  // by shutting down the connection.
  auto client = node.serviceClient<Service>(name, true);
  return begin(client) && client.isValid() && client.call(service);
}

}  // namespace mbncc::console
