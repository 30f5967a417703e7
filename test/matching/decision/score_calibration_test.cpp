// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/score_calibration.hpp"

#include <gtest/gtest.h>

#include "matching/decision/margins.hpp"

namespace mbncc::decision {
namespace {

constexpr double kFirm = -0.2, kAsGoodElsewhere = 0.03;  // agreement

Detection detection_of(double log_odds, double elsewhere) {
  Detection detection;
  detection.odds.best_at_place = log_odds;
  detection.contour_alternative = elsewhere;
  return detection;
}

double calibration_of(double elsewhere, double angle_margin = kNoCompetitor,
                      double instance_margin = kNoCompetitor) {
  return calibration(detection_of(0, elsewhere), angle_margin, instance_margin);
}

TEST(Calibration, AFirmContourRaisesTheScore) {
  EXPECT_GT(calibration_of(kFirm), 0);
  EXPECT_LT(calibration_of(kAsGoodElsewhere), calibration_of(kFirm) - 1);
}

TEST(Calibration, AContourThatFitsAsWellNearbyAddsNothing) {
  EXPECT_NEAR(calibration_of(kAsGoodElsewhere), 0, 0.3);
}

TEST(Calibration, ANearRotationLowersTheScore) {
  EXPECT_DOUBLE_EQ(calibration_of(kFirm, 10), calibration_of(kFirm)) << "far behind";
  EXPECT_LT(calibration_of(kFirm, 1), calibration_of(kFirm) - 2);
  EXPECT_LT(calibration_of(kFirm, -3), calibration_of(kFirm, 1));
}

TEST(Calibration, AFarBetterInstanceLowersTheScore) {
  EXPECT_DOUBLE_EQ(calibration_of(kFirm, 20, -4), calibration_of(kFirm));
  EXPECT_LT(calibration_of(kFirm, 20, -10), calibration_of(kFirm) - 1);
}

TEST(Calibration, AnObjectThatGoesOnBeyondItsOutlineIsUnlikely) {
  const auto calibration_with = [](double continued) {
    Detection detection = detection_of(0, kFirm);
    detection.continued = continued;
    return calibration(detection, kNoCompetitor, kNoCompetitor);
  };
  EXPECT_DOUBLE_EQ(calibration_with(0.15), calibration_of(kFirm)) << "a short part";
  EXPECT_LT(calibration_with(0.4), calibration_of(kFirm) - 5);
  EXPECT_DOUBLE_EQ(calibration_with(3), calibration_with(0.6)) << "bounded";
}

TEST(Calibration, AnUnexaminedContourCountsAsNotFirm) {
  EXPECT_LE(calibration_of(kNotExamined), calibration_of(kAsGoodElsewhere));
}

}  // namespace
}  // namespace mbncc::decision
