// SPDX-License-Identifier: BSD-3-Clause
#include "numeric/lazy.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace mbncc::numeric {
namespace {

TEST(Lazy, IsComputedOnceForAllCopiesAndThreads) {
  std::atomic<int> made{0};
  const Lazy<std::vector<int>> value([&made] {
    ++made;
    return std::vector<int>{1, 2, 3};
  });
  const Lazy<std::vector<int>> copy = value;
  EXPECT_EQ(made, 0);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&, i] { EXPECT_EQ((i % 2 == 0 ? value : copy)->size(), 3u); });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(made, 1);
  EXPECT_EQ(&*value, &*copy);
}

TEST(Lazy, IsEmptyWithoutAFunction) {
  EXPECT_TRUE(Lazy<std::vector<int>>()->empty());
}

}  // namespace
}  // namespace mbncc::numeric
