// SPDX-License-Identifier: BSD-3-Clause
#include "console/service_calls.hpp"

#include <utility>

namespace mbncc::console {

ServiceCalls::ServiceCalls() : worker_([this] { work(); }) {}

ServiceCalls::~ServiceCalls() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
    under_way_.shutdown();
  }
  changed_.notify_all();
  worker_.join();
}

void ServiceCalls::later(std::function<void()> function) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    functions_.push(std::move(function));
  }
  changed_.notify_all();
}

void ServiceCalls::give_up() {
  const std::lock_guard<std::mutex> lock(mutex_);
  under_way_.shutdown();
}

bool ServiceCalls::begin(const ros::ServiceClient& client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (stopping_) return false;
  under_way_ = client;
  return true;
}

void ServiceCalls::work() {
  for (;;) {
    std::function<void()> function;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [this] { return stopping_ || !functions_.empty(); });
      if (stopping_) return;
      function = std::move(functions_.front());
      functions_.pop();
    }
    function();
  }
}

}  // namespace mbncc::console
