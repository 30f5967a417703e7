// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/pending_regions.hpp"

#include <gtest/gtest.h>

namespace mbncc::incremental_search {
namespace {

const cv::Rect kHere(10, 10, 50, 50), kThere(300, 200, 40, 40);

int equally_urgent(const std::string&) {
  return 0;
}

TEST(PendingRegions, AnEmptyListHasNoNextRegion) {
  const PendingRegions pending;
  EXPECT_FALSE(pending.next(equally_urgent).has_value());
  EXPECT_FALSE(pending.contains("part"));
}

TEST(PendingRegions, MostUrgentComesFirst) {
  PendingRegions pending;
  pending.add("a", kHere);
  pending.add("b", kThere);
  const auto due = pending.next([](const std::string& name) { return name == "b" ? 0 : 1; });
  ASSERT_TRUE(due.has_value());
  EXPECT_EQ(due->region, kThere);
  EXPECT_EQ(due->name, "b");
}

TEST(PendingRegions, OldestComesFirst) {
  PendingRegions pending;
  pending.add("a", kThere);
  pending.add("b", kHere);
  EXPECT_EQ(pending.next(equally_urgent)->region, kThere);
}

TEST(PendingRegions, CompletedRegionsAreClosed) {
  PendingRegions pending;
  pending.add("a", kHere);
  pending.add("b", kHere);
  pending.complete("a", kHere);
  EXPECT_FALSE(pending.contains("a"));
  EXPECT_TRUE(pending.contains("b"));
  pending.complete("b", kHere);
  EXPECT_FALSE(pending.contains("b"));
}

TEST(PendingRegions, JoinsOnlyRegionsThatNearlyCoverEachOther) {
  PendingRegions pending;
  pending.add("a", kHere);
  pending.add("a", kHere + cv::Point(5, 0));
  pending.add("a", kThere);
  EXPECT_EQ(pending.next(equally_urgent)->region, (kHere | (kHere + cv::Point(5, 0))));
  pending.complete("a", pending.next(equally_urgent)->region);
  EXPECT_EQ(pending.next(equally_urgent)->region, kThere);
}

TEST(PendingRegions, ForgottenObjectsHaveNoPendingRegions) {
  PendingRegions pending;
  pending.add("a", kHere);
  pending.add("a", kThere);
  pending.add("b", kThere);
  pending.forget("a");
  EXPECT_FALSE(pending.contains("a"));
  EXPECT_TRUE(pending.contains("b"));
}

}  // namespace
}  // namespace mbncc::incremental_search
