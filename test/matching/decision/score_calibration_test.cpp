// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/score_calibration.hpp"

#include <gtest/gtest.h>

#include "matching/decision/margins.hpp"

namespace mbncc::decision {
namespace {

constexpr double kFirm = -0.2, kAsGoodElsewhere = 0.03;  // agreement

Detection detection_of(double log_odds, double elsewhere = kFirm, double projected = 0) {
  Detection detection;
  detection.odds.best_at_place = log_odds;
  detection.contour_alternative = elsewhere;
  detection.shading_free_ncc = projected;
  return detection;
}

double calibration_of(double elsewhere, double angle_margin = kNoCompetitor,
                      double instance_margin = kNoCompetitor) {
  return calibration(detection_of(0, elsewhere), angle_margin, instance_margin);
}

TEST(Calibration, AnOutlineThatLiesFirmlySpeaksForThePose) {
  EXPECT_GT(calibration_of(kFirm), 0);
  EXPECT_LT(calibration_of(kAsGoodElsewhere), calibration_of(kFirm) - 1);
}

TEST(Calibration, ANearRotationSpeaksAgainstThePose) {
  EXPECT_DOUBLE_EQ(calibration_of(kFirm, 10), calibration_of(kFirm)) << "far behind";
  EXPECT_LT(calibration_of(kFirm, 1), calibration_of(kFirm) - 2);
  EXPECT_LT(calibration_of(kFirm, -3), calibration_of(kFirm, 1));
}

TEST(Calibration, AFarBetterInstanceSpeaksAgainstItsLikes) {
  EXPECT_DOUBLE_EQ(calibration_of(kFirm, 20, -4), calibration_of(kFirm));
  EXPECT_LT(calibration_of(kFirm, 20, -10), calibration_of(kFirm) - 1);
}

TEST(Calibration, WhatWasNotExaminedMayLieBetterElsewhere) {
  EXPECT_LE(calibration_of(kNotExamined), calibration_of(kAsGoodElsewhere));
}

TEST(Convincing, ALooseOutlineHasToBeTheMoreCertain) {
  EXPECT_TRUE(is_convincing(detection_of(6), kNoCompetitor));
  EXPECT_FALSE(is_convincing(detection_of(6, kAsGoodElsewhere, 0.9), kNoCompetitor));
  EXPECT_TRUE(is_convincing(detection_of(8, kAsGoodElsewhere), kNoCompetitor));
}

TEST(Convincing, WithoutTextureItHasToBeNearlyCertain) {
  EXPECT_FALSE(is_convincing(detection_of(5), kNoCompetitor));
  EXPECT_TRUE(is_convincing(detection_of(5.5), kNoCompetitor));
  EXPECT_TRUE(is_convincing(detection_of(3, kFirm, 0.6), kNoCompetitor));
  EXPECT_FALSE(is_convincing(detection_of(5, kFirm, 0.5), kNoCompetitor));
  EXPECT_FALSE(is_convincing(detection_of(2.9, kFirm, 0.9), kNoCompetitor));
}

TEST(Convincing, FarBehindAnotherInstanceItMayBeALike) {
  EXPECT_TRUE(is_convincing(detection_of(8, kFirm, 0.9), -2));
  EXPECT_FALSE(is_convincing(detection_of(8, kFirm, 0.9), -5));
  EXPECT_TRUE(is_convincing(detection_of(10), -5)) << "certain, although possibly covered";
}

}  // namespace
}  // namespace mbncc::decision
