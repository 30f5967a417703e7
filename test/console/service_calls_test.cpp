// SPDX-License-Identifier: BSD-3-Clause
#include "console/service_calls.hpp"

#include <gtest/gtest.h>

#include <future>
#include <thread>
#include <vector>

namespace mbncc::console {
namespace {

TEST(ServiceCalls, FunctionsRunInOrderOnAnotherThread) {
  std::vector<int> order;
  std::promise<std::thread::id> last;
  ServiceCalls calls;
  for (int i = 0; i < 3; ++i) calls.later([&order, i] { order.push_back(i); });
  calls.later([&last] { last.set_value(std::this_thread::get_id()); });
  EXPECT_NE(last.get_future().get(), std::this_thread::get_id());
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2}));
}

TEST(ServiceCalls, TheCallerDoesNotWaitForAFunction) {
  std::promise<void> go_on, done;
  ServiceCalls calls;
  calls.later([&] {
    go_on.get_future().wait();
    done.set_value();
  });
  go_on.set_value();  // reached only if later() has returned
  done.get_future().wait();
}

TEST(ServiceCalls, NothingToGiveUpIsNoFault) {
  ServiceCalls calls;
  calls.give_up();
  std::promise<void> done;
  calls.later([&done] { done.set_value(); });
  done.get_future().wait();
}

}  // namespace
}  // namespace mbncc::console
