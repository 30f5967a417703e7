// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/detection.hpp"

#include <gtest/gtest.h>

#include "matching/images.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/search/pose_hypothesis.hpp"
#include "matching/surface_sample.hpp"

namespace mbncc::decision {
namespace {

class RotationTest : public ::testing::Test {
 protected:
  const test::LearningImage source_{1};
  const prepared::PreparedObject object_{test::object_from(source_, {58, 60, 0}),
                                         prepared::Engine::kFast};

  Detection at(double x, double theta, double log_odds, double rotation_odds) const {
    Detection detection;
    detection.object = object_.model.get();
    detection.view = &object_.views.front();
    detection.pose = {x, 100, theta};
    detection.odds.best_at_place = log_odds;
    detection.rotation_odds = rotation_odds;
    return detection;
  }
};

TEST_F(RotationTest, TheResidualUnexplainedByLightDecidesAtOnePlace) {
  const auto compared = resolve_rotations({at(100, 0, 6, 40), at(101, 3, 5, 43)});
  ASSERT_EQ(compared.size(), 2u);
  EXPECT_DOUBLE_EQ(compared[0].pose.theta, 3);
  EXPECT_DOUBLE_EQ(compared[0].log_odds(), 6) << "the place is as likely as before";
  EXPECT_DOUBLE_EQ(compared[1].log_odds(), 3) << "the margin is that of the rotations";
}

TEST_F(RotationTest, GainByAnotherSizeGoesToTheBestRotation) {
  Detection resized = at(100, 0, 6, 40);
  resized.odds.resized = 2;
  const auto compared = resolve_rotations({resized, at(101, 3, 5, 43)});
  ASSERT_EQ(compared.size(), 2u);
  EXPECT_DOUBLE_EQ(compared[0].pose.theta, 3);
  EXPECT_DOUBLE_EQ(compared[0].odds.resized, 2);
}

TEST_F(RotationTest, AHiddenPrintDoesNotExcludeARotation) {
  Detection glossy = at(100, 0, -6, 43);
  glossy.odds.print = 7;
  const auto compared = resolve_rotations({glossy, at(100, 3, 6, 40)});
  ASSERT_EQ(compared.size(), 2U);
  EXPECT_DOUBLE_EQ(compared[0].pose.theta, 0);
}

TEST_F(RotationTest, OtherPlacesAndUnlikelyPosesStayUnchanged) {
  const auto compared =
      resolve_rotations({at(100, 0, 6, 40), at(100, 2, -9, 50), at(400, 1, 2, 60)});
  ASSERT_EQ(compared.size(), 3u);
  EXPECT_DOUBLE_EQ(compared[0].log_odds(), 6);
  EXPECT_DOUBLE_EQ(compared[1].log_odds(), 2);
  EXPECT_DOUBLE_EQ(compared[2].log_odds(), -9);
}

// After half a turn about its own middle, a frame with a handle covers most of itself, but its
// anchor, the centre of the excircle, lies far from where it was.
TEST_F(RotationTest, WhatCoversTheSameMapIsOnePlaceHoweverFarItsAnchor) {
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
  map(cv::Rect(10, 30, 60, 60)) = 255;
  map(cv::Rect(18, 38, 44, 44)) = 0;
  map(cv::Rect(70, 56, 44, 8)) = 255;
  const prepared::PreparedObject frame(test::object_from(test::LearningImage(3, map), {60, 60, 0}),
                                       prepared::Engine::kFast);
  const prepared::PreparedView& view = frame.views.front();
  Detection right = at(200, 0, 6, 43), turned = at(200, kPi, 7, 40);
  for (Detection* one : {&right, &turned}) one->view = &view;
  const cv::Point2d middle = cv::Point2d(39.5, 59.5) - view.anchor;
  turned.pose.x += 2 * middle.x;
  ASSERT_GT(std::abs(2 * middle.x), 0.5 * view.shape.radius());
  const auto compared = resolve_rotations({right, turned});
  EXPECT_DOUBLE_EQ(compared[0].pose.theta, 0);
  EXPECT_DOUBLE_EQ(compared[1].odds.rotation, 3);
}

TEST(RotationOdds, ColourResidualsDecideBetweenEqualCorrelations) {
  evidence::Evidence right, wrong;
  right.contour_score = wrong.contour_score = 0.7;
  right.shading_free_ncc = wrong.shading_free_ncc = 0.97;
  right.log_residual = 1.6;
  wrong.log_residual = 2.1;
  EXPECT_GT(evidence::rotation_odds(right), evidence::rotation_odds(wrong) + 4);
}

TEST(RotationOdds, ContourAndColoursDecideTogetherWithRatios) {
  evidence::Evidence right, wrong;
  right.contour_score = 0.8;
  wrong.contour_score = 0.7;
  EXPECT_GT(evidence::rotation_odds(right, 1), evidence::rotation_odds(wrong, 1) + 5);
  wrong.contour_score = right.contour_score;
  right.log_residual = 1.6;
  wrong.log_residual = 2.1;
  EXPECT_GT(evidence::rotation_odds(right, 1), evidence::rotation_odds(wrong, 1) + 3);
}

TEST(RotationOdds, RatioResidualsDecide) {
  EXPECT_GT(evidence::rotation_odds(evidence::Evidence(), 1.5),
            evidence::rotation_odds(evidence::Evidence(), 2) + 5);
}

TEST(BetterRotation, PrefersTheSmallerColourResidual) {
  search::PoseHypothesis shaded, true_to_colour;
  shaded.pose.theta = 0.06;
  shaded.odds = 7;
  shaded.evidence.log_residual = 2.1;
  true_to_colour.odds = 5;
  true_to_colour.evidence.log_residual = 1.6;
  EXPECT_DOUBLE_EQ(search::better_rotation(shaded, true_to_colour).pose.theta, 0);
  EXPECT_DOUBLE_EQ(search::better_rotation(true_to_colour, shaded).pose.theta, 0);
}

class SurfaceTest : public ::testing::Test {
 protected:
  const test::LearningImage source_{1};
  const prepared::PreparedObject object_{test::object_from(source_, {58, 60, 0}),
                                         prepared::Engine::kFast};
  const templates::SurfaceTemplate& surface_ = object_.views.front().fine.surface;

  /// Residual for the template's own colours times `gain`, with brightness increasing to the right
  /// by `slope` [grey levels / px].
  templates::SurfaceTemplate::Residual residual_of(float gain, float slope) const {
    return surface_.residual(test::sample_of(
        surface_, [&](float colour, float x, float) { return gain * colour + slope * x; }));
  }
};

TEST_F(SurfaceTest, GainAndShadingAreExplained) {
  const templates::SurfaceTemplate::Residual same = residual_of(1, 0);
  EXPECT_LT(surface_.unexplained(same), 1);
  EXPECT_LT(surface_.unexplained(residual_of(0.8, 0.3)), 2) << "gain and slope are no object";
  EXPECT_GT(surface_.unexplained(residual_of(-1, 0)), 20 * surface_.unexplained(same) + 100);
  EXPECT_NEAR(surface_.correlation(same, 0), 1, 1e-3);
}

}  // namespace
}  // namespace mbncc::decision
