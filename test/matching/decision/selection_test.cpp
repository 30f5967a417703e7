// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/selection.hpp"

#include "matching/decision_fixture.hpp"

namespace mbncc::decision {
namespace {

class SelectionTest : public test::DecisionTest {
 protected:
  Detection detection_of(double log_odds, double elsewhere = 0) const {
    return changed([&](Detection& d) {
      d.odds.best_at_place = log_odds;
      d.contour_alternative = elsewhere;
    });
  }

  /// The match from the only detection in an image.
  Match match_of(double log_odds, double elsewhere = 0) const {
    const auto selected =
        select_matches({detection_of(log_odds, elsewhere)}, {config_, std::nullopt, 1, {}, {}, 0});
    return selected.matches.at(0);
  }
};

TEST_F(SelectionTest, OnlyNearlyCertainMatchesAreGraspable) {
  EXPECT_TRUE(match_of(4).graspable);
  EXPECT_FALSE(match_of(3).graspable);
}

TEST_F(SelectionTest, TheScoreDependsOnTheFirmnessOfTheContour) {
  EXPECT_GT(match_of(3, -0.15).score, match_of(3, 0.05).score);
  EXPECT_FALSE(match_of(20, 0.06).graspable) << "it may lie a few pixels off";
  EXPECT_FALSE(match_of(20, kNotExamined).graspable);
}

TEST_F(SelectionTest, ANearRotationLowersTheScoreAndNotTheMargin) {
  Detection one = detection_of(4), turned = one;
  turned.pose.theta = 1;
  turned.odds.best_at_place = 3;
  const auto selected = select_matches({one, turned}, {config_, std::nullopt, 1, {}, {}, 0});
  ASSERT_EQ(selected.matches.size(), 1U);
  EXPECT_LT(selected.matches[0].score, match_of(4).score);
  EXPECT_DOUBLE_EQ(selected.matches[0].margin_angle, 1);
}

TEST_F(SelectionTest, APrintDifferenceDoesNotWeakenACompetitor) {
  const prepared::PreparedObject other{test::object_from(test::LearningImage(2), {58, 60, 0}),
                                       prepared::Engine::kFast};
  Detection behind = detection_of(4);
  behind.object = other.model.get();
  behind.odds.print = 9;
  const auto selected =
      select_matches({detection_of(15), behind}, {config_, std::nullopt, 1, {}, {}, 0});
  ASSERT_EQ(selected.matches.size(), 1U);
  EXPECT_DOUBLE_EQ(selected.matches[0].margin_place, 2);
}

// For one of two look-alikes, the refinement may reach the size in which the object appears, and
// for the other one it may not.
TEST_F(SelectionTest, GainByAnotherSizeDoesNotWeakenACompetitor) {
  const prepared::PreparedObject other{test::object_from(test::LearningImage(2), {58, 60, 0}),
                                       prepared::Engine::kFast};
  Detection resized = detection_of(15), behind = detection_of(7);
  resized.odds.resized = 3;
  behind.object = other.model.get();
  behind.odds.colour = 2;
  behind.odds.mirror = 1;
  const auto margin = [&] {
    const auto selected = select_matches({resized, behind}, {config_, std::nullopt, 1, {}, {}, 0});
    return selected.matches.at(0).margin_place;
  };
  EXPECT_DOUBLE_EQ(margin(), 2) << "the other is judged in the wrong size";
  behind.odds.resized = 2;
  EXPECT_DOUBLE_EQ(margin(), 7) << "both are in another size";
  behind.odds.resized = 4;
  EXPECT_DOUBLE_EQ(margin(), 8) << "the other gained more";
}

TEST_F(SelectionTest, UnconvincingMatchesAreNotAmbiguous) {
  EXPECT_FALSE(match_of(3).ambiguous) << "nothing else is as likely";
}

}  // namespace
}  // namespace mbncc::decision
