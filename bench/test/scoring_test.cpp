// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scoring.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mbncc::bench {
namespace {

constexpr double kDiameter = 80;

Instance at(double x, double y, double degrees, int symmetry = 1) {
  Instance instance;
  instance.pose = {x, y, to_radians(degrees)};
  instance.symmetry = symmetry;
  return instance;
}

Found found(double x, double y, double degrees, double score) {
  return {{x, y, to_radians(degrees)}, score, false, {}};
}

int correct_of(const std::vector<Judged>& judged) {
  int count = 0;
  for (const auto& one : judged) count += one.correct;
  return count;
}

TEST(Judge, AcceptsWithinTheToleranceAndReportsTheErrors) {
  const auto judged = judge({found(101, 50, 12, .9)}, {at(100, 50, 10)}, kDiameter);
  ASSERT_EQ(judged.size(), 1U);
  EXPECT_TRUE(judged[0].correct);
  EXPECT_DOUBLE_EQ(judged[0].position_error, 1);
  EXPECT_NEAR(to_degrees(judged[0].angle_error.value()), 2, 1e-9);
}

TEST(Judge, RefusesPlaceOrAngleOutOfTolerance) {
  EXPECT_EQ(correct_of(judge({found(103.1, 50, 10, .9)}, {at(100, 50, 10)}, kDiameter)), 0);
  EXPECT_EQ(correct_of(judge({found(100, 50, 13.1, .9)}, {at(100, 50, 10)}, kDiameter)), 0);
}

TEST(Judge, TolerancePlaceGrowsWithTheDiameter) {
  EXPECT_EQ(correct_of(judge({found(105, 50, 10, .9)}, {at(100, 50, 10)}, 200)), 1);
}

TEST(Judge, CountsASecondDetectionOfAnInstanceAsWrong) {
  const auto judged =
      judge({found(100, 50, 0, .5), found(101, 50, 0, .9)}, {at(100, 50, 0)}, kDiameter);
  EXPECT_EQ(correct_of(judged), 1);
  EXPECT_TRUE(judged[0].correct);
  EXPECT_DOUBLE_EQ(judged[0].score, .9);
}

TEST(Judge, GivesEachOfTwoCloseInstancesItsDetection) {
  const auto judged = judge({found(101.4, 50, 0, .9), found(101.2, 50, 0, .8)},
                            {at(100, 50, 0), at(102, 50, 0)}, kDiameter);
  EXPECT_EQ(correct_of(judged), 2);
}

TEST(Judge, MeasuresAnglesModuloTheSymmetry) {
  EXPECT_EQ(correct_of(judge({found(100, 50, 190, .9)}, {at(100, 50, 10)}, kDiameter)), 0);
  EXPECT_EQ(correct_of(judge({found(100, 50, 190, .9)}, {at(100, 50, 10, 2)}, kDiameter)), 1);
  const auto round = judge({found(100, 50, 77, .9)}, {at(100, 50, 10, 0)}, kDiameter);
  EXPECT_TRUE(round[0].correct);
  EXPECT_FALSE(round[0].angle_error);
}

TEST(Judge, WrapsAnglesAtHalfATurn) {
  EXPECT_EQ(correct_of(judge({found(100, 50, -179, .9)}, {at(100, 50, 179)}, kDiameter)), 1);
}

TEST(Judge, WeighsErrorsByTheClaimedCovariance) {
  Found one = found(101, 52, 1, .9);
  const double deviation = to_radians(0.5);
  one.covariance = cv::Matx33d(1, 0, 0, 0, 4, 0, 0, 0, deviation * deviation);
  const auto judged = judge({one}, {at(100, 50, 0)}, kDiameter);
  EXPECT_NEAR(judged[0].squared_error.value(), 1 + 1 + 4, 1e-9);
  EXPECT_FALSE(judge({one}, {at(100, 50, 0, 0)}, kDiameter)[0].squared_error);
}

TEST(SymmetryOf, ReadsThePeriodTag) {
  EXPECT_EQ(symmetry_of({"round", "sym:0"}), 0);
  EXPECT_EQ(symmetry_of({"sym:90"}), 4);
  EXPECT_EQ(symmetry_of({"symmetric"}), 1);
}

class TallyTest : public ::testing::Test {
 protected:
  void add(const std::vector<Found>& detections, const std::vector<Instance>& instances) {
    tally_.add(judge(detections, instances, kDiameter), instances.size(), 10);
  }
  Tally tally_;
};

TEST_F(TallyTest, CountsRecallPrecisionAndF1) {
  add({found(100, 50, 0, .9)}, {at(100, 50, 0)});
  add({found(300, 50, 0, .8)}, {at(100, 50, 0)});
  add({}, {at(100, 50, 0)});
  const Figures figures = tally_.figures(0);
  EXPECT_DOUBLE_EQ(figures.recall, 1.0 / 3);
  EXPECT_DOUBLE_EQ(figures.precision, 1.0 / 2);
  EXPECT_DOUBLE_EQ(figures.f1, 2.0 / 5);
}

TEST_F(TallyTest, ThresholdLeavesWeakerDetectionsOut) {
  add({found(100, 50, 0, .9), found(300, 50, 0, .5)}, {at(100, 50, 0)});
  EXPECT_DOUBLE_EQ(tally_.figures(.6).precision, 1);
  EXPECT_DOUBLE_EQ(tally_.figures(.5).precision, .5);
}

TEST_F(TallyTest, RecallWithoutAlarmSilencesAbsentTargets) {
  add({found(100, 50, 0, .9)}, {at(100, 50, 0)});
  add({found(100, 50, 0, .4)}, {at(100, 50, 0)});
  add({found(20, 20, 0, .6)}, {});
  const Figures figures = tally_.figures(.3);
  EXPECT_EQ(figures.alarms, 1);
  EXPECT_DOUBLE_EQ(figures.recall, 1);
  EXPECT_DOUBLE_EQ(figures.recall_without_alarm, .5);
}

TEST_F(TallyTest, BestThresholdMaximisesF1) {
  add({found(100, 50, 0, .9), found(300, 50, 0, .5)}, {at(100, 50, 0)});
  add({found(100, 50, 0, .7), found(300, 50, 0, .6)}, {at(100, 50, 0)});
  EXPECT_DOUBLE_EQ(tally_.best_threshold(), .7);
}

TEST_F(TallyTest, WithoutDetectionsNothingPassesTheBestThreshold) {
  add({}, {at(100, 50, 0)});
  const Figures figures = tally_.figures(tally_.best_threshold());
  EXPECT_EQ(figures.correct, 0);
  EXPECT_TRUE(std::isnan(figures.precision));
}

TEST(TaggedTally, CountsAnInstanceUnderItsOwnTagsAlone) {
  Target target;
  target.tags = {"multi"};
  target.instances = {at(100, 50, 0), at(300, 50, 0)};
  target.instances[1].tags = {"occluded"};
  TaggedTally tally;
  tally.add(judge({found(100, 50, 0, .9)}, target.instances, kDiameter), target, 1);
  EXPECT_EQ(tally.all().figures(0).instances, 2);
  EXPECT_DOUBLE_EQ(tally.by_tag().at("multi").figures(0).recall, .5);
  EXPECT_EQ(tally.by_tag().at("occluded").figures(0).instances, 1);
  EXPECT_DOUBLE_EQ(tally.by_tag().at("occluded").figures(0).recall, 0);
}

}  // namespace
}  // namespace mbncc::bench
