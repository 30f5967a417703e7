// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/pending_regions.hpp"

#include <gtest/gtest.h>

namespace mbncc::incremental_search {
namespace {

const cv::Rect kHere(10, 10, 50, 50), kThere(300, 200, 40, 40);

int equally_urgent(const std::string&) {
  return 0;
}

/// The region that is searched next for one object.
PendingRegions::Pending next_of(const PendingRegions& pending) {
  return pending.next(equally_urgent, 0, 1).at(0);
}

TEST(PendingRegions, AnEmptyListHasNoNextRegion) {
  const PendingRegions pending;
  EXPECT_TRUE(pending.next(equally_urgent, 0, 9).empty());
  EXPECT_FALSE(pending.contains("part"));
  EXPECT_FALSE(pending.is_open(kHere));
}

TEST(PendingRegions, MostUrgentComesFirst) {
  PendingRegions pending;
  pending.add("a", kHere);
  pending.add("b", kThere);
  const auto due = pending.next([](const std::string& name) { return name == "b" ? 0 : 1; }, 1, 9);
  ASSERT_EQ(due.size(), 1U) << "the other object's region is elsewhere";
  EXPECT_EQ(due[0].region, kThere);
  EXPECT_EQ(due[0].name, "b");
}

TEST(PendingRegions, ObjectsAtOnePlaceAreSearchedForTogether) {
  PendingRegions pending;
  for (const auto* name : {"a", "b", "c"}) pending.add(name, kHere);
  pending.add("d", kThere);
  pending.add("c", kThere);
  const auto due = pending.next(equally_urgent, 0, 9);
  ASSERT_EQ(due.size(), 3U) << "each object once, and none elsewhere";
  for (const auto& one : due) EXPECT_EQ(one.region, kHere);
  EXPECT_EQ(pending.next(equally_urgent, 0, 2).size(), 2U);
}

TEST(PendingRegions, LessUrgentObjectsAreLeftOut) {
  PendingRegions pending;
  pending.add("a", kHere);
  pending.add("b", kHere);
  const auto urgency = [](const std::string& name) { return name == "a" ? 1 : 2; };
  EXPECT_EQ(pending.next(urgency, 1, 9).size(), 1U);
  EXPECT_TRUE(pending.next(urgency, 0, 9).empty());
}

TEST(PendingRegions, OldestComesFirst) {
  PendingRegions pending;
  pending.add("a", kThere);
  pending.add("b", kHere);
  EXPECT_EQ(next_of(pending).region, kThere);
}

TEST(PendingRegions, CompletedRegionsAreClosed) {
  PendingRegions pending;
  pending.add("a", kHere);
  pending.add("b", kHere);
  pending.complete("a", kHere);
  EXPECT_FALSE(pending.contains("a"));
  EXPECT_TRUE(pending.is_open({0, 0, 20, 20}));
  pending.complete("b", kHere);
  EXPECT_FALSE(pending.is_open({0, 0, 20, 20}));
}

TEST(PendingRegions, JoinsOnlyRegionsThatNearlyCoverEachOther) {
  PendingRegions pending;
  pending.add("a", kHere);
  pending.add("a", kHere + cv::Point(5, 0));
  pending.add("a", kThere);
  EXPECT_EQ(next_of(pending).region, (kHere | (kHere + cv::Point(5, 0))));
  pending.complete("a", next_of(pending).region);
  EXPECT_EQ(next_of(pending).region, kThere);
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
