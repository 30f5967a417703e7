// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/clutter.hpp"

#include <gtest/gtest.h>

#include "matching/images.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::decision {
namespace {

class ClutterTest : public ::testing::Test {
 protected:
  const test::LearningImage source_{1};
  const prepared::PreparedObject object_{test::object_from(source_, {58, 60, 0}),
                                         prepared::Engine::kFast};
  const prepared::PreparedObject other_{test::object_from(source_, {58, 60, 0}, "other"),
                                        prepared::Engine::kFast};

  static Detection at(const prepared::PreparedObject& object, double x, double log_odds) {
    Detection detection;
    detection.object = object.model.get();
    detection.view = &object.views.front();
    detection.pose = {x, 100, 0};
    detection.odds.best_at_place = log_odds;
    return detection;
  }
};

TEST_F(ClutterTest, ASinglePlaceHasNoPenalty) {
  std::vector<Detection> detections{at(object_, 100, 4), at(object_, 101, 3)};
  apply_clutter_penalty(detections);
  EXPECT_DOUBLE_EQ(detections[0].log_odds(), 4);
  EXPECT_DOUBLE_EQ(detections[1].log_odds(), 3);
}

TEST_F(ClutterTest, UnlikelyPlacesAddNoPenalty) {
  std::vector<Detection> detections{at(object_, 100, 4), at(object_, 400, -30)};
  apply_clutter_penalty(detections);
  EXPECT_DOUBLE_EQ(detections[0].log_odds(), 4);
}

TEST_F(ClutterTest, EveryUncertainPlaceRaisesThePenalty) {
  std::vector<Detection> detections{at(object_, 100, 4)};
  double before = 4;
  for (int k = 1; k <= 3; ++k) {
    detections.push_back(at(object_, 100 + 200 * k, 1));
    auto discounted = detections;
    apply_clutter_penalty(discounted);
    EXPECT_LT(discounted[0].log_odds(), before);
    EXPECT_DOUBLE_EQ(discounted[0].log_odds() - discounted[1].log_odds(), 3) << "margins stay";
    before = discounted[0].log_odds();
  }
}

TEST_F(ClutterTest, CertainInstancesDoNotRaiseThePenalty) {
  std::vector<Detection> detections{at(object_, 100, 15), at(object_, 300, 12), at(object_, 500, 9),
                                    at(object_, 700, 10), at(object_, 900, 4)};
  apply_clutter_penalty(detections);
  EXPECT_GT(detections[4].log_odds(), 0) << "covered, it is still one more of them";
  EXPECT_LT(detections[4].log_odds(), 4) << "and it might be a like";
}

TEST_F(ClutterTest, UncertainPlacesCountBehindManyOthers) {
  std::vector<Detection> detections;
  for (int k = 0; k < 20; ++k) detections.push_back(at(object_, 100 + 200 * k, 9 - 0.25 * k));
  apply_clutter_penalty(detections);
  EXPECT_LT(detections[0].log_odds(), 1) << "a pattern: as many uncertain places as likely ones";
}

TEST_F(ClutterTest, UncertainPlacesBesideAnInstanceStayUnlikely) {
  std::vector<Detection> detections{at(object_, 100, 15), at(object_, 300, 3), at(object_, 500, 3),
                                    at(object_, 700, 3)};
  apply_clutter_penalty(detections);
  EXPECT_GT(detections[0].log_odds(), 5);
  EXPECT_LT(detections[1].log_odds(), 0);
}

TEST_F(ClutterTest, ThePenaltyOfTheWholeImageIsTheMinimum) {
  std::vector<Detection> detections{at(object_, 100, 4), at(other_, 300, 4)};
  const auto taken = apply_clutter_penalty(detections, {{"object", 2.5}, {"gone", 1}});
  EXPECT_DOUBLE_EQ(detections[0].log_odds(), 1.5);
  EXPECT_DOUBLE_EQ(detections[1].log_odds(), 4);
  EXPECT_DOUBLE_EQ(taken.at("object"), 2.5);
  EXPECT_DOUBLE_EQ(taken.at("gone"), 1) << "and is handed on";
}

TEST_F(ClutterTest, OtherObjectsDoNotRaiseThePenalty) {
  std::vector<Detection> detections{at(object_, 100, 4), at(other_, 300, 4)};
  apply_clutter_penalty(detections);
  EXPECT_DOUBLE_EQ(detections[0].log_odds(), 4);
  EXPECT_DOUBLE_EQ(detections[1].log_odds(), 4);
}

TEST_F(ClutterTest, ManyObjectsLowerTheOddsOfEach) {
  EXPECT_DOUBLE_EQ(multiple_testing_penalty(1), 0);
  EXPECT_DOUBLE_EQ(multiple_testing_penalty(kFewObjects), 0);
  EXPECT_LT(multiple_testing_penalty(10), multiple_testing_penalty(40));
  std::vector<Detection> detections{at(object_, 100, 4), at(object_, 101, 3)};
  const auto taken = apply_clutter_penalty(detections, {}, 1.5);
  EXPECT_DOUBLE_EQ(detections[0].log_odds(), 2.5);
  EXPECT_DOUBLE_EQ(detections[1].log_odds(), 1.5);
  EXPECT_DOUBLE_EQ(taken.at("object"), 1.5);
}

}  // namespace
}  // namespace mbncc::decision
