// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/pending_regions.hpp"

#include <gtest/gtest.h>

namespace mbncc {
namespace {

const cv::Rect kHere(10, 10, 50, 50), kThere(300, 200, 40, 40);

int equally_urgent(const std::string&) {
  return 0;
}

TEST(PendingRegions, NothingOwedIsNothingDue) {
  const PendingRegions debts;
  EXPECT_FALSE(debts.next(equally_urgent).has_value());
  EXPECT_FALSE(debts.owes("part"));
  EXPECT_FALSE(debts.is_open(kHere));
}

TEST(PendingRegions, MostUrgentComesFirst) {
  PendingRegions debts;
  debts.owe("a", kHere);
  debts.owe("b", kThere);
  const auto due = debts.next([](const std::string& name) { return name == "b" ? 0 : 1; });
  ASSERT_TRUE(due.has_value());
  EXPECT_EQ(due->region, kThere);
  EXPECT_EQ(due->name, "b");
}

TEST(PendingRegions, OldestComesFirst) {
  PendingRegions debts;
  debts.owe("a", kThere);
  debts.owe("b", kHere);
  EXPECT_EQ(debts.next(equally_urgent)->region, kThere);
}

TEST(PendingRegions, PaidOnesAreClosed) {
  PendingRegions debts;
  debts.owe("a", kHere);
  debts.owe("b", kHere);
  debts.pay("a", kHere);
  EXPECT_FALSE(debts.owes("a"));
  EXPECT_TRUE(debts.is_open({0, 0, 20, 20}));
  debts.pay("b", kHere);
  EXPECT_FALSE(debts.is_open({0, 0, 20, 20}));
}

TEST(PendingRegions, RegionsThatNearlyCoverEachOtherAreJoinedOthersKept) {
  PendingRegions debts;
  debts.owe("a", kHere);
  debts.owe("a", kHere + cv::Point(5, 0));
  debts.owe("a", kThere);
  EXPECT_EQ(debts.next(equally_urgent)->region, (kHere | (kHere + cv::Point(5, 0))));
  debts.pay("a", debts.next(equally_urgent)->region);
  EXPECT_EQ(debts.next(equally_urgent)->region, kThere);
}

TEST(PendingRegions, ForgottenObjectsOweNothing) {
  PendingRegions debts;
  debts.owe("a", kHere);
  debts.owe("a", kThere);
  debts.owe("b", kThere);
  debts.forget("a");
  EXPECT_FALSE(debts.owes("a"));
  EXPECT_TRUE(debts.owes("b"));
}

}  // namespace
}  // namespace mbncc
