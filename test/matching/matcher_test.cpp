// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/matcher.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "matching/matcher_fixture.hpp"

namespace mbncc {
namespace {

using test::LearningImage;
using test::MatcherTest;
using test::object_from;
using test::place;
using test::texture;

TEST_F(MatcherTest, FindsTheObjectAtAnyRotation) {
  const Matcher matcher = this->matcher();
  for (int k = 0; k < 12; ++k) {
    const Pose2D truth{120.3 + 5 * k, 90.7 + 3 * k, wrap_angle(0.2 + k * kPi / 6)};
    cv::Mat scene = texture({320, 240}, 50 + k, 4);
    place(scene, source_, reference_.position(), truth);
    const SearchResult result = matcher.find(scene);
    ASSERT_FALSE(result.matches.empty()) << "rotation " << k;
    expect_at(result.matches[0], truth);
    EXPECT_GT(result.matches[0].similarity, 0.9);
    EXPECT_EQ(result.matches[0].name, "object");
  }
}

TEST_F(MatcherTest, ScoreMapIsHighestWhereTheObjectLies) {
  cv::Mat scene = texture({320, 240}, 52, 4);
  place(scene, source_, reference_.position(), {190.3, 100.7, 0.8});
  const cv::Mat scores = matcher().score_map(scene);
  ASSERT_EQ(scores.type(), CV_32FC1);
  ASSERT_EQ(scores.size(), scene.size());
  cv::Point highest;
  double value = 0;
  cv::minMaxLoc(scores, nullptr, &value, nullptr, &highest);
  EXPECT_LT(cv::norm(highest - cv::Point(190, 101)), 12);
  EXPECT_GT(value, 0.8);
  EXPECT_LE(value, 1.001);
}

TEST_F(MatcherTest, UsesReferencePointAndDirection) {
  Pose2D reference{40, 70, 0.7};
  const Matcher matcher = matcher_of({object_from(source_, reference)});
  cv::Mat scene = texture({320, 240}, 60, 4);
  place(scene, source_, reference.position(), {150.5, 110.25, 1.1});
  const SearchResult result = matcher.find(scene);
  ASSERT_EQ(result.matches.size(), 1u);
  expect_at(result.matches[0], {150.5, 110.25, 1.1 + 0.7});
}

TEST_F(MatcherTest, FindsTwoInstances) {
  const std::vector<Pose2D> truths{{80, 70, 0.4}, {220, 150, -2}};
  cv::Mat scene = texture({320, 240}, 61, 4);
  for (const auto& truth : truths) place(scene, source_, reference_.position(), truth);
  const SearchResult result = matcher().find(scene);
  ASSERT_EQ(result.matches.size(), 2u);
  const bool in_order = result.matches[0].pose.x < 150;
  expect_at(result.matches[in_order ? 0 : 1], truths[0]);
  expect_at(result.matches[in_order ? 1 : 0], truths[1]);
  SearchRequest one;
  one.max_instances = 1;
  EXPECT_EQ(matcher().find(scene, one).matches.size(), 1u);
}

TEST_F(MatcherTest, ReportsThatMaxInstancesIsReached) {
  cv::Mat scene(240, 420, CV_8UC3, cv::Scalar(90, 120, 130));
  for (const double x : {80., 210., 340.})
    place(scene, source_, reference_.position(), {x, 120, x / 100});
  SearchRequest request;
  for (const int most : {1, 2, 3, 4}) {
    request.max_instances = most;
    const SearchResult result = matcher().find(scene, request);
    EXPECT_EQ(result.matches.size(), std::min<std::size_t>(most, 3)) << most;
    EXPECT_EQ(result.limited.size(), most <= 3 ? 1u : 0u) << most;
  }
}

TEST_F(MatcherTest, TheOnlyInstanceIsNotLimited) {
  cv::Mat scene(240, 420, CV_8UC3, cv::Scalar(90, 120, 130));
  place(scene, source_, reference_.position(), {210, 120, 2.1});
  SearchRequest request;
  request.max_instances = 1;
  EXPECT_TRUE(matcher().find(scene, request).limited.empty());
}

TEST_F(MatcherTest, FindsThirtyInstances) {
  cv::Mat scene = texture({1000, 840}, 61, 4);
  for (int k = 0; k < 30; ++k)
    place(scene, source_, reference_.position(),
          {100.0 + 160 * (k % 6), 90.0 + 160 * (k / 6), 0.7 * k});
  const SearchResult result = matcher().find(scene);
  EXPECT_EQ(result.matches.size(), 30u);
  EXPECT_TRUE(result.limited.empty());
}

TEST_F(MatcherTest, DisabledObjectsAreNotFound) {
  cv::Mat scene = texture({320, 240}, 62, 4);
  place(scene, source_, reference_.position(), {160, 120, 0.9});
  const auto model = object_from(source_, reference_);
  model->enabled = false;
  const SearchResult result = matcher_of({model}).find(scene);
  EXPECT_TRUE(result.matches.empty());
  EXPECT_TRUE(result.searched.empty());
}

TEST_F(MatcherTest, UnreportedDetectionsAreRivals) {
  cv::Mat scene = texture({320, 240}, 61, 4);
  place(scene, source_, reference_.position(), {80, 70, 0.4});
  place(scene, source_, reference_.position(), {220, 150, -2});
  SearchRequest one;
  one.max_instances = 1;
  const SearchResult result = matcher().find(scene, one);
  ASSERT_EQ(result.matches.size(), 1u);
  ASSERT_FALSE(result.rivals.empty());
  EXPECT_EQ(result.rivals[0].name, "object");
  EXPECT_GT(result.rivals[0].log_odds(), 0);
}

TEST_F(MatcherTest, DistinguishesObjects) {
  const LearningImage other(2);
  const Matcher matcher = matcher_of(
      {object_from(source_, reference_, "first"), object_from(other, reference_, "second")});
  cv::Mat scene = texture({320, 240}, 62, 4);
  place(scene, other, reference_.position(), {160, 120, 0.9});
  const SearchResult result = matcher.find(scene);
  ASSERT_EQ(result.matches.size(), 1u);
  EXPECT_EQ(result.matches[0].name, "second");
  EXPECT_EQ(result.searched, (std::vector<std::string>{"first", "second"}));
}

TEST_F(MatcherTest, ALargerOrSmallerCopyIsNeverGraspable) {
  for (const double scale : {0.75, 0.85, 0.92, 1.08, 1.15, 1.3}) {
    cv::Mat scene = texture({320, 240}, 64, 4);
    place(scene, source_, reference_.position(), {160, 120, 0.4});
    cv::Mat rescaled;
    cv::resize(scene, rescaled, {}, scale, scale, cv::INTER_AREA);
    for (const auto& match : matcher().find(rescaled).matches)
      EXPECT_FALSE(match.graspable) << "scale " << scale << ", score " << match.score;
  }
}

TEST_F(MatcherTest, AnObjectALittleLargerOrSmallerMayBeGrasped) {
  for (const double scale : {0.95, 1.05}) {
    cv::Mat scene = texture({320, 240}, 70, 4), seen;
    place(scene, source_, reference_.position(), {160, 120, 0.9});
    cv::resize(scene, seen, {}, scale, scale, scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    const SearchResult result = matcher().find(seen);
    ASSERT_EQ(result.matches.size(), 1u) << "scale " << scale;
    EXPECT_NEAR(result.matches[0].scale, scale, 0.01);
    EXPECT_TRUE(result.matches[0].graspable) << "scale " << scale;
  }
}

TEST_F(MatcherTest, FindsLargerAndSmallerObjectsOnRequest) {
  SearchConfig config;
  config.scale_range = 0.15;
  const Matcher matcher = matcher_of({object_from(source_, reference_)}, config);
  for (const double scale : {0.88, 1.0, 1.12}) {
    cv::Mat scene = texture({320, 240}, 61, 4), seen;
    place(scene, source_, reference_.position(), {150.3, 110.7, 0.7});
    cv::resize(scene, seen, {}, scale, scale, scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    const SearchResult result = matcher.find(seen);
    ASSERT_FALSE(result.matches.empty()) << "scale " << scale;
    const Match& match = result.matches[0];
    EXPECT_NEAR(match.scale, scale, 0.04);
    EXPECT_NEAR(match.pose.x, (150.3 + 0.5) * scale - 0.5, 1);
    EXPECT_NEAR(match.pose.y, (110.7 + 0.5) * scale - 0.5, 1);
    EXPECT_LT(angle_distance(match.pose.theta, 0.7), to_radians(1));
  }
}

TEST_F(MatcherTest, NamesSkippedObjects) {
  auto disabled = object_from(source_, reference_, "off");
  disabled->enabled = false;
  const Matcher matcher = matcher_of({object_from(source_, reference_), disabled});
  SearchRequest request;
  request.names = {"off", "nowhere", "object"};
  const SearchResult result = matcher.find(texture({64, 64}, 63), request);
  EXPECT_EQ(result.searched, std::vector<std::string>{"object"});
  EXPECT_EQ(result.skipped, (std::vector<std::string>{"off: disabled", "nowhere: unknown"}));
}

TEST_F(MatcherTest, FindsObjectsThatHangOverTheBorder) {
  cv::Mat scene = texture({320, 240}, 68, 4);
  const Pose2D truth{300, 120, 0};  // a sixth of the map lies beyond the right border
  place(scene, source_, reference_.position(), truth);
  const SearchResult result = matcher().find(scene);
  ASSERT_FALSE(result.matches.empty());
  expect_at(result.matches[0], truth);
  EXPECT_LT(result.matches[0].visible, 0.95);
  EXPECT_GT(result.matches[0].visible, 0.6);
}

TEST_F(MatcherTest, FindsTheObjectAtAnotherExposure) {
  const Pose2D truth{150.3, 110.6, 2.4};
  cv::Mat scene = texture({320, 240}, 69, 4), darker;
  place(scene, source_, reference_.position(), truth);
  scene.convertTo(darker, CV_8U, 0.75, 12);
  const SearchResult result = matcher().find(darker);
  ASSERT_FALSE(result.matches.empty());
  expect_at(result.matches[0], truth);
}

TEST_F(MatcherTest, AnIsolatedObjectMayBeGrasped) {
  cv::Mat scene = texture({320, 240}, 70, 4);
  place(scene, source_, reference_.position(), {160, 120, 0.9});
  const SearchResult result = matcher().find(scene);
  ASSERT_FALSE(result.matches.empty());
  EXPECT_TRUE(result.matches[0].graspable);
  EXPECT_FALSE(result.matches[0].ambiguous);
  EXPECT_EQ(result.matches[0].symmetry, 1);
  EXPECT_FALSE(result.matches[0].outline.empty());
}

TEST_F(MatcherTest, AnUncertainPoseIsNotGrasped) {
  cv::Mat scene = texture({320, 240}, 70, 4);
  place(scene, source_, reference_.position(), {160, 120, 0.9});
  for (const bool of_angle : {false, true}) {
    SearchConfig strict;
    (of_angle ? strict.max_angle_deviation : strict.max_place_deviation) = 0;
    const SearchResult result = matcher_of({object_from(source_, reference_)}, strict).find(scene);
    ASSERT_FALSE(result.matches.empty());
    EXPECT_FALSE(result.matches[0].graspable);
    EXPECT_FALSE(result.matches[0].ambiguous) << "uncertain, not mistaken";
  }
}

TEST_F(MatcherTest, APartOfAnotherColourIsNotGrasped) {
  cv::Mat scene = texture({320, 240}, 70, 4);
  place(scene, source_, reference_.position(), {160, 120, 0.9});
  cv::Mat part = scene(cv::Rect(160, 80, 60, 80));
  for (int y = 0; y < part.rows; ++y)
    for (int x = 0; x < part.cols; ++x) {
      auto& pixel = part.at<cv::Vec3b>(y, x);
      std::swap(pixel[0], pixel[2]);
      pixel[0] = cv::saturate_cast<uchar>(pixel[0] / 2);
    }
  for (const auto& match : matcher().find(scene).matches) EXPECT_FALSE(match.graspable);
}

TEST_F(MatcherTest, LooksForReferencePointsInTheRegionOnly) {
  cv::Mat scene = texture({320, 240}, 64, 4);
  const Pose2D truth{100, 100, 0.3};
  place(scene, source_, reference_.position(), truth);
  SearchRequest request;
  request.roi = {90, 90, 20, 20};
  ASSERT_EQ(matcher().find(scene, request).matches.size(), 1u);
  request.roi = {150, 90, 100, 100};
  EXPECT_TRUE(matcher().find(scene, request).matches.empty());
}

// A weaker instance in the region, a perfect one outside.
TEST_F(MatcherTest, WhatLiesOutsideTheRegionCounts) {
  const Pose2D outside{250, 160, -1}, within{90, 90, 0.3};
  cv::Mat scene = texture({320, 240}, 64, 4);
  place(scene, source_, reference_.position(), outside);
  place(scene, source_, reference_.position(), within);
  scene(cv::Rect(80, 20, 40, 60)) = cv::Scalar(40, 80, 120);
  SearchRequest request;
  request.roi = {60, 60, 60, 60};
  const auto whole = matcher().find(scene), in_region = matcher().find(scene, request);
  ASSERT_EQ(in_region.matches.size(), 1u);
  const auto same =
      std::find_if(whole.matches.begin(), whole.matches.end(), [&](const Match& match) {
        return cv::norm(match.pose.position() - in_region.matches[0].pose.position()) < 1;
      });
  ASSERT_NE(same, whole.matches.end());
  EXPECT_NEAR(in_region.matches[0].log_odds(), same->log_odds(), 1e-6);
  cv::Mat alone = scene.clone();
  alone(cv::Rect(190, 90, 130, 150)) = cv::Scalar(90, 110, 70);
  EXPECT_LT(same->log_odds(), matcher().find(alone).matches.at(0).log_odds() - 0.5);
}

TEST_F(MatcherTest, FindsNothingWithoutAnObject) {
  const Matcher matcher = this->matcher();
  cv::Mat noise(240, 320, CV_8UC3);
  cv::RNG(5).fill(noise, cv::RNG::UNIFORM, 0, 256);
  const std::vector<cv::Mat> images{cv::Mat::zeros(240, 320, CV_8UC3),
                                    cv::Mat(240, 320, CV_8UC3, cv::Scalar(90, 120, 130)),
                                    noise,
                                    texture({320, 240}, 65, 4),
                                    cv::Mat::zeros(16, 16, CV_8UC1),
                                    texture({17, 33}, 66)};
  for (const auto& image : images) EXPECT_TRUE(matcher.find(image).matches.empty());
}

TEST_F(MatcherTest, RefusesImagesItCannotSearch) {
  const Matcher matcher = this->matcher();
  EXPECT_THROW(matcher.find(cv::Mat()), std::invalid_argument);
  EXPECT_THROW(matcher.find(cv::Mat::zeros(15, 64, CV_8UC3)), std::invalid_argument);
  EXPECT_THROW(matcher.find(cv::Mat::zeros(64, 64, CV_16UC1)), std::invalid_argument);
}

TEST_F(MatcherTest, SeveralViewsGiveOnePoseWithoutRivalsAtEveryRotation) {
  const auto view_at = [&](const Pose2D& pose, unsigned seed) {
    cv::Mat scene = texture({240, 240}, seed, 4), map = cv::Mat::zeros(240, 240, CV_8UC1);
    place(scene, source_, reference_.position(), pose);
    LearningImage white = source_;
    white.surface = cv::Mat(white.map.size(), CV_8UC1, cv::Scalar(255));
    place(map, white, reference_.position(), pose);
    return crop_view(scene, map, pose);
  };
  auto object = object_from(source_, reference_);
  for (const double theta : {1.7, 3.0, -1.4})
    object->views.push_back(view_at({120.4, 118.7, theta}, 90));
  const Matcher matcher = matcher_of({object});
  for (int k = 0; k < 12; ++k) {
    const Pose2D truth{150.3 + 3 * k, 110.7 - 2 * k, wrap_angle(0.25 + k * kPi / 6)};
    cv::Mat scene = texture({320, 240}, 150 + static_cast<unsigned>(k), 4);
    place(scene, source_, reference_.position(), truth);
    const SearchResult result = matcher.find(scene);
    ASSERT_EQ(result.matches.size(), 1u) << "rotation " << k;
    expect_at(result.matches[0], truth);
    EXPECT_TRUE(result.matches[0].graspable) << "rotation " << k;
  }
}

TEST_F(MatcherTest, RefusesBrokenModels) {
  Matcher matcher;
  auto model = object_from(source_, reference_);
  model->views.front().map = cv::Mat::zeros(model->views.front().map.size(), CV_8UC1);
  EXPECT_THROW(matcher.set_objects({model}), std::invalid_argument);
}

}  // namespace
}  // namespace mbncc
