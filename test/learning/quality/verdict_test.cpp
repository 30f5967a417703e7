// SPDX-License-Identifier: BSD-3-Clause
// The limits of GOOD, MARGINAL and BAD.
#include "learning/quality/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "learning/teaching/lesson_checks.hpp"

namespace mbncc::quality {
namespace {

class VerdictTest : public testing::Test {
 protected:
  /// A quality without any weakness.
  Quality sound() const {
    Quality quality;
    quality.area = 10 * learning_.min_area;
    quality.contrast = 20;
    quality.edge_agreement = 1;
    quality.self_score = 1;
    return quality;
  }

  Quality decided(Quality quality, const std::optional<CutEvidence>& evidence = CutEvidence(),
                  bool touches_border = false) const {
    decide(quality, touches_border, evidence, learning_, search_);
    EXPECT_EQ(quality.reasons.size(), quality.advice.size());
    return quality;
  }

  Verdict verdict_of(const Quality& quality) const { return decided(quality).verdict; }
  Verdict verdict_with(const CutEvidence& evidence) const {
    return decided(sound(), evidence).verdict;
  }

  double risk_with(const CutEvidence& evidence) const {
    return 1 - decided(sound(), evidence).outline_probability;
  }

  static CutEvidence stable(double stability) {
    CutEvidence evidence;
    evidence.stability = stability;
    return evidence;
  }

  const LearningConfig learning_{};
  const SearchConfig search_{};
};

TEST_F(VerdictTest, AMapWithoutDoubtsIsGood) {
  const Quality quality = decided(sound());
  EXPECT_EQ(quality.verdict, Verdict::kGood);
  EXPECT_TRUE(quality.reasons.empty());
  EXPECT_EQ(decided(sound(), std::nullopt).verdict, Verdict::kGood);
  EXPECT_EQ(teaching::error_of(quality), LearnError::kSuccess);
}

TEST_F(VerdictTest, RiskAboveAFifthIsNotGoodAndAboveAHalfIsBad) {
  for (double stability = 1; stability > 0; stability -= 0.01) {
    const double risk = risk_with(stable(stability));
    const Verdict expected = risk > 0.5   ? Verdict::kBad
                             : risk > 0.2 ? Verdict::kMarginal
                                          : Verdict::kGood;
    EXPECT_EQ(verdict_with(stable(stability)), expected) << risk;
  }
  EXPECT_GT(risk_with(stable(0)), 0.9);
}

TEST_F(VerdictTest, EverySignalRaisesTheRisk) {
  const double usual = risk_with({});
  EXPECT_LT(usual, 0.1);
  EXPECT_GT(risk_with(stable(0.8)), usual + 0.15);
  CutEvidence weak, outside, beside, unverified;
  weak.boundary_contrast = 0.3;
  EXPECT_GT(risk_with(weak), usual + 0.1);
  outside.change_outside = 0.3;
  EXPECT_GT(risk_with(outside), usual + 0.03);
  beside.change_beside = 0.5;
  EXPECT_GT(risk_with(beside), usual + 0.03);
  unverified.verified = false;
  EXPECT_GT(risk_with(unverified), usual + 0.02);
  CutEvidence lost = unverified;
  lost.region_span = 0.2;
  EXPECT_GT(risk_with(lost), risk_with(unverified) + 0.1);
  CutEvidence disputed = unverified;
  disputed.stability = 0.3;
  EXPECT_GT(risk_with(disputed), risk_with(unverified) + 0.1);
  Quality off_edges = sound();
  off_edges.edge_agreement = 0.3;
  EXPECT_GT(1 - decided(off_edges).outline_probability, usual + 0.1);
  EXPECT_GT(1 - decided(off_edges, unverified).outline_probability, risk_with(unverified) + 0.3);
}

TEST_F(VerdictTest, WarningsOfTheCutPreventGood) {
  CutEvidence touch, outside, beside, hole, several, arrived, unverified;
  touch.cut_off = 0.04;
  hole.unconfirmed_hole = 0.11;
  several.second_departure = 0.51;
  arrived.edges_after = 0.21;
  outside.change_outside = 0.11;
  beside.change_beside = 0.09;
  unverified.verified = false;
  for (const CutEvidence& evidence : {touch, outside, beside, hole, several, arrived, unverified})
    EXPECT_EQ(verdict_with(evidence), Verdict::kMarginal);
  touch.cut_off = 1;
  beside.change_beside = 1;
  EXPECT_EQ(verdict_with(touch), Verdict::kMarginal);
  EXPECT_EQ(verdict_with(beside), Verdict::kMarginal);
  hole.unconfirmed_hole = 0.41;
  EXPECT_EQ(verdict_with(hole), Verdict::kBad);
  outside.change_outside = 0.51;
  EXPECT_EQ(verdict_with(outside), Verdict::kBad);
}

TEST_F(VerdictTest, AShadowMustLieInsideTheRegion) {
  CutEvidence evidence;
  evidence.region_touch = 0.06;
  EXPECT_EQ(verdict_with(evidence), Verdict::kGood);
  evidence.shadow_like = true;
  EXPECT_EQ(verdict_with(evidence), Verdict::kBad);
  evidence.region_touch = 0.04;
  EXPECT_EQ(verdict_with(evidence), Verdict::kMarginal);
}

TEST_F(VerdictTest, AnObjectCutByTheBorderIsRefused) {
  const Quality quality = decided(sound(), CutEvidence(), true);
  EXPECT_EQ(quality.verdict, Verdict::kBad);
  EXPECT_EQ(teaching::error_of(quality), LearnError::kTouchesBorder);
}

TEST_F(VerdictTest, SmallObjectsWarnAndSmallerOnesAreRefused) {
  Quality quality = sound();
  quality.area = 2 * learning_.min_area;
  EXPECT_EQ(verdict_of(quality), Verdict::kGood);
  quality.area = 2 * learning_.min_area - 1;
  EXPECT_EQ(verdict_of(quality), Verdict::kMarginal);
  quality.area = learning_.min_area - 1;
  EXPECT_EQ(verdict_of(quality), Verdict::kBad);
  EXPECT_EQ(teaching::error_of(decided(quality)), LearnError::kTooSmall);
}

TEST_F(VerdictTest, APlainSurfaceIsNamedIfTheObjectIsNotFoundAgain) {
  Quality quality = sound();
  quality.contrast = 1;
  EXPECT_EQ(verdict_of(quality), Verdict::kGood);
  quality.self_score = search_.min_score - 0.01;
  EXPECT_EQ(teaching::error_of(decided(quality)), LearnError::kLowTexture);
  quality.contrast = 6;
  EXPECT_EQ(teaching::error_of(decided(quality)), LearnError::kNotDistinct);
}

TEST_F(VerdictTest, AnObjectThatIsNotFoundAgainIsRefused) {
  Quality quality = sound();
  quality.self_score = search_.confirm_score - 0.01;
  EXPECT_EQ(verdict_of(quality), Verdict::kMarginal);
  quality.self_score = search_.min_score - 0.01;
  EXPECT_EQ(verdict_of(quality), Verdict::kBad);
  EXPECT_EQ(teaching::error_of(decided(quality)), LearnError::kNotDistinct);
}

TEST_F(VerdictTest, ALookAlikeIsReportedAboveSeventyPercent) {
  Quality quality = sound();
  for (const double runner_up : {0.69, 0.71}) {
    quality.runner_up = runner_up;
    const Quality told = decided(quality);
    EXPECT_EQ(std::count(told.reasons.begin(), told.reasons.end(), "not_distinct"),
              runner_up > 0.7 ? 1 : 0);
    EXPECT_EQ(told.verdict, Verdict::kGood);
  }
}

TEST_F(VerdictTest, RefusalsPrecedeWarnings) {
  CutEvidence outside = stable(1);
  outside.change_outside = 0.6;  // refuses
  outside.cut_off = 0.2;         // warns before
  outside.change_beside = 0.1;   // warns after
  const Quality quality = decided(sound(), outside);
  EXPECT_EQ(quality.verdict, Verdict::kBad);
  ASSERT_GE(quality.reasons.size(), 3u);
  EXPECT_EQ(quality.reasons.front(), "change_outside_region");
  EXPECT_EQ(teaching::error_of(quality), LearnError::kQualityBad);
}

}  // namespace
}  // namespace mbncc::quality
