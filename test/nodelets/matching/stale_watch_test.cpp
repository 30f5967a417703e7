// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/stale_watch.hpp"

#include <gtest/gtest.h>

namespace mbncc::nodelets {
namespace {

using std::chrono::milliseconds;

TEST(StaleWatch, ReportsSilenceOnceASecond) {
  const auto start = StaleWatch::Clock::now();
  StaleWatch watch(1.5);
  watch.restart(start);
  EXPECT_FALSE(watch.due(start));
  EXPECT_FALSE(watch.due(start + milliseconds(1499)));
  EXPECT_TRUE(watch.due(start + milliseconds(1500)));
  EXPECT_FALSE(watch.due(start + milliseconds(1501))) << "told already";
  EXPECT_FALSE(watch.due(start + milliseconds(2499)));
  EXPECT_TRUE(watch.due(start + milliseconds(2500))) << "and again a second later";
}

TEST(StaleWatch, SilenceIsMeasuredFromTheLastRestart) {
  const auto start = StaleWatch::Clock::now();
  StaleWatch watch(1.5);
  watch.restart(start);
  watch.restart(start + milliseconds(1000));
  EXPECT_FALSE(watch.due(start + milliseconds(2499)));
  EXPECT_TRUE(watch.due(start + milliseconds(2500)));
}

TEST(StaleWatch, SilenceIsMeasuredFromTheStart) {
  const auto start = StaleWatch::Clock::now();
  StaleWatch watch(1.5);
  EXPECT_FALSE(watch.due(start + milliseconds(1400)));
  EXPECT_TRUE(watch.due(start + std::chrono::hours(1)));
}

}  // namespace
}  // namespace mbncc::nodelets
