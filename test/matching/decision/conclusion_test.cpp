// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/conclusion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "matching/decision/margins.hpp"

namespace mbncc::decision {
namespace {

class ConclusionTest : public ::testing::Test {
 protected:
  ConclusionTest() {
    match_.name = "key";
    match_.score = 0.99;
    match_.odds.best_at_place = 12;
    match_.margin_angle = kNoCompetitor;
    match_.covariance = cv::Matx33d::diag({0.01, 0.01, 1e-6});
    detection_.odds.best_at_place = 12;
    detection_.contour_alternative = 0;
    detection_.print_difference = detection_.edge_difference = detection_.detail_difference = 0;
  }

  void verify() {
    match_.doubts = doubts_about(match_, detection_, match_.covariance, config_);
    conclude(match_, config_);
  }

  /// Expects that it is refused for this reason only.
  void expect_refused(const std::string& reason, bool ambiguous) {
    verify();
    EXPECT_FALSE(match_.graspable);
    EXPECT_EQ(match_.ambiguous, ambiguous);
    ASSERT_EQ(match_.reasons.size(), 1U);
    EXPECT_EQ(match_.reasons[0], reason);
  }

  SearchConfig config_;
  Match match_;
  Detection detection_;
};

TEST_F(ConclusionTest, WithoutDoubtsAMatchIsGraspableAndHasNoReason) {
  verify();
  EXPECT_TRUE(match_.graspable);
  EXPECT_FALSE(match_.ambiguous);
  EXPECT_TRUE(match_.reasons.empty());
  EXPECT_EQ(match_.margin_place, kNoCompetitor);
}

TEST_F(ConclusionTest, NamesTheBestCompetitor) {
  match_.competitors = {{"far", {1, 2}, 3}, {"near", {40.4, 50.2}, 11}};
  expect_refused("competitor near at 40, 50 (margin 1.0)", true);
  EXPECT_DOUBLE_EQ(match_.margin_place, 1);
  match_.competitors.pop_back();
  verify();
  EXPECT_TRUE(match_.graspable) << "9 is margin enough";
}

TEST_F(ConclusionTest, AnUndecidedAngleIsNamed) {
  match_.margin_angle = 2.5;
  expect_refused("angle open (margin 2.5)", true);
  match_.other_angle = to_radians(270);
  expect_refused("angle open (margin 2.5 to -90 degrees)", true);
}

TEST_F(ConclusionTest, AnotherColourIsNamed) {
  detection_.colour_difference = 0.26;
  expect_refused("colour of a part differs", true);
}

TEST_F(ConclusionTest, AnotherPrintIsNamed) {
  detection_.print_difference = 0.16;
  expect_refused("print inside the outline differs", true);
  detection_.print_difference = 0;
  detection_.edge_difference = 1.21;
  expect_refused("print inside the outline differs", true);
  detection_.edge_difference = 0;
  detection_.detail_difference = 1.51;
  expect_refused("print inside the outline differs", true);
}

TEST_F(ConclusionTest, AColourThatGoesOnBeyondTheOutlineIsNamed) {
  detection_.continued = 0.21;
  expect_refused("part of something larger", true);
}

TEST_F(ConclusionTest, AnAbsentPartIsNamed) {
  detection_.absent = 0.21;
  expect_refused("a part is absent", true);
}

TEST_F(ConclusionTest, TheMirrorImageIsNamed) {
  detection_.mirror_alternative = true;
  expect_refused("mirrored fits as well", true);
}

TEST_F(ConclusionTest, AnotherSizeIsNamed) {
  detection_.size_alternative = true;
  expect_refused("another size fits better", true);
}

TEST_F(ConclusionTest, DisplacedPartsAreNamed) {
  detection_.torn = true;
  expect_refused("upper and lower part lie apart", false);
}

TEST_F(ConclusionTest, ALowScoreIsNotAmbiguous) {
  match_.score = config_.confirm_score - 0.01;
  match_.margin_angle = 2.5;
  verify();
  EXPECT_FALSE(match_.ambiguous);
  EXPECT_EQ(match_.reasons.size(), 2U);
}

TEST_F(ConclusionTest, AContourThatFitsBesideItIsNamed) {
  detection_.contour_alternative = 0.051;
  expect_refused("outline fits better beside it", false);
  detection_.contour_alternative = kNotExamined;
  expect_refused("too unlikely to be examined", false);
}

TEST_F(ConclusionTest, WeakEvidenceIsNamed) {
  detection_.odds.best_at_place = 3.9;
  expect_refused("evidence too weak", false);
  detection_.odds.best_at_place = 4;
  verify();
  EXPECT_TRUE(match_.graspable);
}

TEST_F(ConclusionTest, AnUncertainPositionIsNamed) {
  match_.covariance(1, 1) = 9;
  expect_refused("position known to 3.0 px only", false);
}

TEST_F(ConclusionTest, AnUncertainAngleMattersUnlessItIsRound) {
  match_.covariance(2, 2) = to_radians(3) * to_radians(3);
  expect_refused("angle known to 3.0 degrees only", false);
  match_.symmetry = 0;
  verify();
  EXPECT_TRUE(match_.graspable);
}

TEST_F(ConclusionTest, ANonFiniteCovariancePreventsAGrasp) {
  for (const int axis : {0, 1, 2}) {
    match_.covariance = cv::Matx33d::diag({0.01, 0.01, 1e-6});
    match_.covariance(axis, axis) = std::nan("");
    verify();
    EXPECT_FALSE(match_.graspable) << axis;
  }
}

TEST_F(ConclusionTest, AnUnreachableMarginLeavesNothingGraspable) {
  config_.min_margin_place = kNoCompetitor + 1;
  expect_refused("min_margin_place is above the largest margin", true);
}

TEST_F(ConclusionTest, NotANumberPreventsAGrasp) {
  const Match match = match_;
  const Detection detection = detection_;
  for (double* value :
       {&match_.score, &match_.visible, &match_.margin_angle, &match_.odds.best_at_place,
        &detection_.colour_difference, &detection_.continued, &detection_.absent,
        &detection_.contour_alternative, &detection_.print_difference, &detection_.edge_difference,
        &detection_.detail_difference}) {
    match_.competitors = {{"far", {1, 2}, 0}};
    *value = std::nan("");
    verify();
    EXPECT_FALSE(match_.graspable);
    match_ = match;
    detection_ = detection;
  }
}

TEST_F(ConclusionTest, APartOutsideTheImageIsNamed) {
  match_.visible = 0.3;
  expect_refused("70 % outside", false);
}

}  // namespace
}  // namespace mbncc::decision
