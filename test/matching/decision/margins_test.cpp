// SPDX-License-Identifier: BSD-3-Clause
// Tests that a graspable instance was compared with its competitors.
#include "matching/decision/margins.hpp"

#include <opencv2/imgproc.hpp>

#include "matching/decision_fixture.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc {
namespace {

using MarginsTest = test::DecisionTest;

TEST_F(MarginsTest, EveryInstanceIsComparedWithItsOwnOtherAngles) {
  cv::Mat map = cv::Mat::zeros(60, 60, CV_8UC1);
  cv::circle(map, {30, 30}, 22, 255, cv::FILLED);
  test::LearningImage source(3, map);
  // With little texture, nearly any angle fits.
  source.surface.convertTo(source.surface, -1, 0.15, 120);
  source.surface.copyTo(source.image, map);
  const Pose2D reference{30, 30, 0};
  Matcher matcher;
  matcher.set_objects({test::object_from(source, reference)});
  cv::Mat scene = test::texture({400, 300}, 50, 4);
  for (int k = 0; k < 6; ++k)
    test::place(scene, source, reference.position(),
                {60.3 + 130 * (k % 3), 80.7 + 140 * (k / 3), 1.1 * k - 3});
  const auto matches = matcher.find(scene).matches;
  ASSERT_EQ(matches.size(), 6u);
  for (const auto& match : matches) EXPECT_LT(match.margin_angle, 20) << match.pose.x;
}

TEST_F(MarginsTest, APoseBesideWidensTheCovariance) {
  for (const double margin : {0., 3.}) {
    const decision::Detection beside = changed([&](decision::Detection& d) {
      d.pose.x += 2.4;
      d.pose.y += 3.2;
      d.odds.best_at_place -= margin;
    });
    const Match match = select({sound(), beside}).matches.at(0);
    const double probability = 1 / (1 + std::exp(margin));
    EXPECT_NEAR(match.covariance(0, 0), 0.01 + probability * 2.4 * 2.4, 1e-4);
    EXPECT_NEAR(match.covariance(0, 1), probability * 2.4 * 3.2, 1e-4);
    EXPECT_NEAR(match.covariance(1, 1), 0.01 + probability * 3.2 * 3.2, 1e-4);
    EXPECT_NEAR(match.margin_place, decision::kNoCompetitor, 1e-9);
    EXPECT_EQ(match.graspable, margin > 0) << "the position is known to 2.3 and .7 px";
  }
}

TEST_F(MarginsTest, APoseFarBesideOfSimilarOddsForbidsAGrasp) {
  for (const double margin : {2., 4., 8.}) {
    const decision::Detection beside = changed([&](decision::Detection& d) {
      d.pose.x += 20;
      d.odds.best_at_place -= margin;
    });
    EXPECT_EQ(select({sound(), beside}).matches.at(0).graspable, margin > 5) << margin;
  }
}

TEST_F(MarginsTest, AnImpossiblePoseBesideChangesNothing) {
  const decision::Detection beside = changed([](decision::Detection& d) {
    d.pose.x += 20;
    d.odds.best_at_place = -1e4;
  });
  const Match match = select({sound(), beside}).matches.at(0);
  EXPECT_EQ(match.covariance, match_of(sound()).covariance);
  EXPECT_TRUE(match.graspable);
}

TEST_F(MarginsTest, OnlyADisplacedPoseOfTheSameObjectAtTheSameAngleWidensTheCovariance) {
  enum Widened { kNone, kPosition, kBoth };
  const auto widened = [&](double off, double turn, const prepared::PreparedObject& object) {
    const decision::Detection beside = changed([&](decision::Detection& d) {
      d.object = object.model.get();
      d.view = &object.views.front();
      d.pose.x += off;
      d.pose.theta += to_radians(turn);
      d.odds.best_at_place -= 1;
    });
    const cv::Matx33d covariance = select({sound(), beside}).matches.at(0).covariance;
    if (covariance(0, 0) < 0.5) return kNone;
    return covariance(2, 2) < 1e-5 ? kPosition : kBoth;
  };
  EXPECT_EQ(widened(5, 0, object_), kPosition);
  EXPECT_EQ(widened(5, 4, object_), kBoth);
  EXPECT_EQ(widened(2, 0, object_), kNone) << "the same pose within its accuracy";
  EXPECT_EQ(widened(5, 20, object_), kNone) << "a competing angle";
  EXPECT_EQ(widened(5, 0, other_), kNone) << "a competing object";
}

}  // namespace
}  // namespace mbncc
