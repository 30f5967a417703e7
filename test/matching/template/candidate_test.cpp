// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/candidate.hpp"

#include <gtest/gtest.h>

namespace mbncc::templates {
namespace {

Candidate at(double x, double degrees, double value) {
  return {{x, 0, to_radians(degrees)}, 0, value};
}

constexpr double kUnlimited = Suppression::kUnlimited;

TEST(SuppressionTest, SymmetricRotationsAreEqual) {
  const auto left = [](int symmetry) {
    std::vector<Candidate> turned{at(0, 0, 3), at(0, 90, 2), at(0, 180, 1)};
    suppress(turned, {10, kUnlimited, kUnlimited, {1, 20, symmetry}});
    return turned.size();
  };
  EXPECT_EQ(left(1), 3U);
  EXPECT_EQ(left(2), 2U);
  EXPECT_EQ(left(4), 1U);
  EXPECT_EQ(left(0), 1U) << "round";
}

TEST(SuppressionTest, KeepsTheBetterOfTwoSimilarCandidates) {
  std::vector<Candidate> candidates{at(0, 0, 3), at(0.5, 0, 5), at(3, 0, 4)};
  suppress(candidates, {10, kUnlimited, kUnlimited, {1, 20}});
  ASSERT_EQ(candidates.size(), 2U);
  EXPECT_DOUBLE_EQ(candidates[0].value, 5);
  EXPECT_DOUBLE_EQ(candidates[1].value, 4);
}

TEST(SuppressionTest, RemovesCandidatesFarBehindTheBest) {
  std::vector<Candidate> candidates{at(0, 0, 20), at(100, 0, 6), at(200, 0, 4)};
  suppress(candidates, {10, 15});
  EXPECT_EQ(candidates.size(), 2U);
}

TEST(SuppressionTest, KeepsAtMostTheRequestedNumber) {
  std::vector<Candidate> candidates{at(0, 0, 20), at(100, 0, 19), at(200, 0, 18)};
  suppress(candidates, {2, 15});
  EXPECT_EQ(candidates.size(), 2U);
}

TEST(SuppressionTest, KeepsLikelyCandidatesAtSeparatePlaces) {
  std::vector<Candidate> candidates{at(0, 0, 20), at(100, 0, 2), at(101, 0, 1), at(1, 0, 3),
                                    at(200, 0, -1)};
  suppress(candidates, {10, 15, 10});
  ASSERT_EQ(candidates.size(), 2U);
  EXPECT_DOUBLE_EQ(candidates[1].pose.x, 100);
}

TEST(SuppressionTest, LimitsTheRotationsAtOnePlace) {
  std::vector<Candidate> candidates{at(0, 0, 20),   at(0, 30, 19),  at(0, 60, 18),
                                    at(100, 0, 12), at(101, 0, 11), at(200, 0, -1)};
  suppress(candidates, {2, kUnlimited, 10});
  ASSERT_EQ(candidates.size(), 3U);
  EXPECT_DOUBLE_EQ(candidates[2].pose.x, 100);
}

}  // namespace
}  // namespace mbncc::templates
