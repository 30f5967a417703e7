#include "matching/candidate.hpp"

#include <gtest/gtest.h>

namespace mbncc {
namespace {

Candidate at(double x, double degrees, double value) {
  return {{x, 0, to_radians(degrees)}, 0, value};
}

TEST(CandidateTest, RotationsOfASymmetricObjectAreDuplicates) {
  const std::vector<Candidate> turned{at(0, 0, 3), at(0, 90, 2), at(0, 180, 1)};
  const auto left = [&](int symmetry) {
    auto candidates = turned;
    drop_duplicates(candidates, {1, 20, symmetry}, 10);
    return candidates.size();
  };
  EXPECT_EQ(left(1), 3U);
  EXPECT_EQ(left(2), 2U);
  EXPECT_EQ(left(4), 1U);
  EXPECT_EQ(left(0), 1U) << "round";
}

TEST(CandidateTest, WhatIsFarBehindIsDropped) {
  std::vector<Candidate> candidates{at(0, 0, 20), at(100, 0, 6), at(200, 0, 4)};
  keep_hopeful(candidates, 10, 15);
  EXPECT_EQ(candidates.size(), 2U);
}

TEST(CandidateTest, WhatIsLikelyAtAPlaceOfItsOwnIsHopeful) {
  std::vector<Candidate> candidates{at(0, 0, 20), at(100, 0, 2), at(101, 0, 1), at(1, 0, 3),
                                    at(200, 0, -1)};
  keep_hopeful_places(candidates, 10, 15, 10);
  ASSERT_EQ(candidates.size(), 2U);
  EXPECT_DOUBLE_EQ(candidates[1].pose.x, 100);
}

TEST(CandidateTest, RotationsAtOnePlaceLeaveRoomForOtherPlaces) {
  const std::vector<Candidate> several{at(0, 0, 20),   at(0, 30, 19),  at(0, 60, 18),
                                       at(100, 0, 12), at(101, 0, 11), at(200, 0, -1)};
  const auto expect_both_places = [](const std::vector<Candidate>& candidates) {
    ASSERT_EQ(candidates.size(), 3U);
    EXPECT_DOUBLE_EQ(candidates[2].pose.x, 100);
  };
  auto candidates = several;
  drop_duplicates(candidates, {1, 20}, 2, 10);
  expect_both_places(candidates);
  candidates = several;
  keep_hopeful(candidates, 2, 15, 10);
  expect_both_places(candidates);
}

TEST(CandidateTest, AFurtherPlaceIsLikelyByItselfAndApart) {
  const std::vector<Pose2D> known{{0, 0, 0}, {100, 0, 0}};
  EXPECT_TRUE(is_further_place(at(50, 0, 1), known, 20));
  EXPECT_FALSE(is_further_place(at(50, 0, -1), known, 20)) << "not likely";
  EXPECT_FALSE(is_further_place(at(90, 45, 1), known, 20)) << "another rotation";
}

TEST(CandidateTest, APlaceFarBehindIsNotHopeful) {
  std::vector<Candidate> candidates{at(0, 0, 20), at(0, 30, 19), at(100, 0, 4)};
  keep_hopeful(candidates, 2, 15, 10);
  EXPECT_EQ(candidates.size(), 2U);
}

TEST(CandidateTest, NoMoreAreKeptThanWanted) {
  std::vector<Candidate> candidates{at(0, 0, 20), at(100, 0, 19), at(200, 0, 18)};
  keep_hopeful_places(candidates, 2, 15, 10);
  EXPECT_EQ(candidates.size(), 2U);
}

}  // namespace
}  // namespace mbncc
