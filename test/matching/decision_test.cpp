// SPDX-License-Identifier: BSD-3-Clause
// Conditions for graspable and ambiguous detections, and competitors.
#include "matching/decision/margins.hpp"
#include "matching/decision_fixture.hpp"

namespace mbncc {
namespace {

using DecisionTest = test::DecisionTest;

TEST_F(DecisionTest, ACertainMatchIsGraspable) {
  const Match match = match_of(sound());
  EXPECT_TRUE(match.graspable);
  EXPECT_FALSE(match.ambiguous);
  EXPECT_NEAR(match.margin_place, decision::kNoCompetitor, 1e-9);
  EXPECT_NEAR(match.margin_angle, decision::kNoCompetitor, 1e-9);
}

TEST_F(DecisionTest, AMatchWithACompetitorIsAmbiguous) {
  const std::vector<std::function<void(decision::Detection&)>> doubts{
      [](decision::Detection& d) { d.colour_difference = 0.26; },
      [](decision::Detection& d) { d.size_alternative = true; },
      [](decision::Detection& d) { d.mirror_alternative = true; }};
  for (std::size_t i = 0; i < doubts.size(); ++i) {
    const Match match = match_of(changed(doubts[i]));
    EXPECT_FALSE(match.graspable) << i;
    EXPECT_TRUE(match.ambiguous) << i;
  }
  EXPECT_TRUE(
      match_of(changed([](decision::Detection& d) { d.colour_difference = 0.24; })).graspable);
}

TEST_F(DecisionTest, AnUncertainPoseIsNotGrasped) {
  const double place = config_.max_place_deviation, angle = to_radians(config_.max_angle_deviation);
  const auto with = [&](double x, double y, double theta) {
    return match_of(changed([&](decision::Detection& d) {
      d.pose = {0, 0, 0};
      d.covariance = d.grasp_covariance = cv::Matx33d::diag({x * x, y * y, theta * theta});
    }));
  };
  // The reference point of this object differs from the anchor, so that rotations displace it.
  EXPECT_TRUE(with(0.9 * place, 0.9 * place, 0).graspable);
  for (const Match& match :
       {with(1.1 * place, 0, 0), with(0, 1.1 * place, 0), with(0, 0, 1.1 * angle)}) {
    EXPECT_FALSE(match.graspable);
    EXPECT_FALSE(match.ambiguous) << "uncertain, not mistaken";
  }
}

TEST_F(DecisionTest, TheAccuracyIsThatOfTheWorstDirection) {
  const auto along = [&](double direction, double deviation) {
    const cv::Point2d way = rotate({deviation, 0}, direction);
    return match_of(changed([&](decision::Detection& d) {
      d.grasp_covariance(0, 0) += way.x * way.x;
      d.grasp_covariance(1, 1) += way.y * way.y;
      d.grasp_covariance(0, 1) = d.grasp_covariance(1, 0) = way.x * way.y;
    }));
  };
  EXPECT_FALSE(
      match_of(changed([](decision::Detection& d) { d.grasp_covariance(0, 0) = -1; })).graspable)
      << "no variance";
  for (const double direction : {0., 0.5, kPi / 4, 2.}) {
    EXPECT_TRUE(along(direction, 0.95 * config_.max_place_deviation).graspable) << direction;
    EXPECT_FALSE(along(direction, 1.05 * config_.max_place_deviation).graspable) << direction;
  }
}

TEST_F(DecisionTest, ARoundObjectsAngleDoesNotMatter) {
  auto model = std::make_shared<ObjectModel>(*test::object_from(source_, {58, 60, 0}));
  model->symmetry = 0;
  const prepared::PreparedObject round(model, prepared::Engine::kFast);
  const Match match = match_of(changed([&](decision::Detection& d) {
    d.object = round.model.get();
    d.view = &round.views.front();
    d.covariance(2, 2) = 1e-3;
  }));
  EXPECT_EQ(match.symmetry, 0);
  EXPECT_TRUE(match.graspable);
}

TEST_F(DecisionTest, AContourThatFitsBetterElsewhereIsNotGrasped) {
  const auto at = [&](double elsewhere) {
    return match_of(changed([&](decision::Detection& d) { d.contour_alternative = elsewhere; }));
  };
  EXPECT_TRUE(at(0.04).graspable);
  EXPECT_FALSE(at(0.06).graspable);
}

TEST_F(DecisionTest, MostOfTheObjectMustBeInTheImage) {
  const auto seen = [&](double part) {
    return match_of(changed([&](decision::Detection& d) { d.visible = part; })).graspable;
  };
  EXPECT_TRUE(seen(config_.min_visible));
  EXPECT_FALSE(seen(config_.min_visible - 0.01));
}

TEST_F(DecisionTest, GraspableRequiresConfirmScore) {
  SearchConfig strict;
  strict.confirm_score = 0.9999;
  const decision::Detection likely =
      changed([](decision::Detection& d) { d.odds.best_at_place = 6; });
  const decision::Selection selected = select({likely}, strict, std::nullopt, 1);
  EXPECT_LT(selected.matches.at(0).score, strict.confirm_score);
  EXPECT_FALSE(selected.matches[0].graspable);
  EXPECT_FALSE(selected.matches[0].ambiguous);
}

TEST_F(DecisionTest, AnotherObjectAtThePlaceMakesAmbiguous) {
  for (const double behind : {5.0, 7.0}) {
    const decision::Detection rival = changed([&](decision::Detection& d) {
      d.object = other_.model.get();
      d.view = &other_.views.front();
      d.odds.best_at_place -= behind;
    });
    const decision::Selection selected = select({sound(), rival});
    ASSERT_EQ(selected.matches.size(), 1u) << "one place, one object";
    EXPECT_NEAR(selected.matches[0].margin_place, behind, 1e-9);
    EXPECT_EQ(selected.matches[0].graspable, behind > config_.min_margin_place);
    EXPECT_EQ(selected.matches[0].ambiguous, behind < config_.min_margin_place);
    ASSERT_EQ(selected.rivals.size(), 1u) << "it competes for the place";
    EXPECT_EQ(selected.rivals[0].name, "other");
    EXPECT_NEAR(selected.matches[0].odds.uncalibrated() - selected.rivals[0].log_odds(), behind,
                1e-9);
  }
}

TEST_F(DecisionTest, TheBestOfSeveralCompetitorsCounts) {
  const auto turned = [&](double degrees, double behind) {
    return changed([&](decision::Detection& d) {
      d.pose.theta = to_radians(degrees);
      d.odds.best_at_place -= behind;
    });
  };
  for (const auto& angles :
       {std::vector<decision::Detection>{sound(), turned(40, 9), turned(90, 8)},
        std::vector<decision::Detection>{sound(), turned(90, 8), turned(40, 9)}})
    EXPECT_NEAR(select(angles).matches.at(0).margin_angle, 8, 1e-9);
}

// Of what lies outside the region, another instance does not compete, another object does.
TEST_F(DecisionTest, WhatLiesOutsideTheRegionIsNotReported) {
  const auto at = [&](double x, const prepared::PreparedObject* object) {
    return changed([&](decision::Detection& d) {
      d.pose.x += x;
      if (object) {
        d.object = object->model.get();
        d.view = &object->views.front();
      }
    });
  };
  const Pose2D here = decision::object_pose(sound());
  decision::AcceptanceSettings acceptance{config_, std::nullopt, 1, {}, {}, 0};
  acceptance.part = cv::Rect(cvRound(here.x) - 5, cvRound(here.y) - 5, 11, 11);
  const auto alone = decision::select_matches({sound(), at(300, nullptr)}, acceptance);
  ASSERT_EQ(alone.matches.size(), 1u);
  EXPECT_TRUE(alone.matches[0].graspable);
  ASSERT_EQ(alone.rivals.size(), 1u);
  EXPECT_FALSE(alone.rivals[0].in_part);
  const auto confused = decision::select_matches({sound(), at(8, &other_)}, acceptance);
  ASSERT_EQ(confused.matches.size(), 1u);
  EXPECT_TRUE(confused.matches[0].ambiguous);
}

// The symmetry centre lies 100 px to the right of the reference point.
TEST_F(DecisionTest, ASymmetricObjectIsReportedAtTheEquivalentPoseInTheRegion) {
  const Pose2D here = decision::object_pose(sound());
  for (const int symmetry : {0, 1, 2, 4}) {
    templates::ViewFrame view = *sound().view;
    view.symmetry = symmetry;
    view.symmetry_centre =
        transform(inverse(sound().pose), here.position() + cv::Point2d(100, 0)) / sound().scale;
    const auto detection = changed([&](decision::Detection& d) { d.view = &view; });
    decision::AcceptanceSettings acceptance{config_, std::nullopt, 1, {}, {}, 0};
    const cv::Point below(cvRound(here.x) + 100, cvRound(here.y) + 100);
    const cv::Point right(cvRound(here.x) + 200, cvRound(here.y));
    for (const auto& expected : {below, right}) {
      acceptance.part = cv::Rect(expected.x - 5, expected.y - 5, 11, 11);
      const auto matches = decision::select_matches({detection}, acceptance).matches;
      const bool equivalent = symmetry != 1 && (symmetry != 2 || expected == right);
      ASSERT_EQ(matches.size(), equivalent ? 1u : 0u) << symmetry << " " << expected;
      if (!equivalent) continue;
      const Pose2D& pose = matches[0].pose;
      EXPECT_LT(cv::norm(pose.position() - cv::Point2d(expected)), 1);
      EXPECT_NEAR(angle_distance(pose.theta - here.theta, expected == right ? kPi : -kPi / 2), 0,
                  0.02);
    }
  }
}

TEST_F(DecisionTest, AMuchBetterInstanceOutsideTheRegionPreventsAGrasp) {
  const decision::Detection likely =
      changed([](decision::Detection& d) { d.odds.best_at_place = 6; });
  for (const double elsewhere : {6.0, 25.0}) {
    decision::AcceptanceSettings acceptance{config_, std::nullopt, 1, {}, {{"object", elsewhere}},
                                            0};
    EXPECT_EQ(decision::select_matches({likely}, acceptance).matches.at(0).graspable,
              elsewhere < 10);
  }
}

TEST_F(DecisionTest, ABetterObjectAtThePlaceMakesAmbiguousToo) {
  // Its score is lower because its outline is less distinct, although its uncalibrated odds are
  // higher.
  const decision::Detection better = changed([&](decision::Detection& d) {
    d.object = other_.model.get();
    d.view = &other_.views.front();
    d.odds.best_at_place += 0.5;
    d.contour_alternative = 0.08;
  });
  const decision::Selection selected = select({sound(), better});
  ASSERT_EQ(selected.matches.size(), 1u);
  EXPECT_EQ(selected.matches[0].name, "object");
  EXPECT_NEAR(selected.matches[0].margin_place, -0.5, 1e-9);
  EXPECT_FALSE(selected.matches[0].graspable);
}

TEST_F(DecisionTest, AnotherAngleAtThePlaceMakesAmbiguous) {
  for (const double degrees : {5.0, 15.0, 90.0}) {
    const decision::Detection turned = changed([&](decision::Detection& d) {
      d.pose.theta = to_radians(degrees);
      d.odds.best_at_place -= 3;
    });
    const Match match = select({sound(), turned}).matches.at(0);
    EXPECT_EQ(match.graspable, degrees < 10) << degrees;
    EXPECT_EQ(match.ambiguous, degrees > 10) << degrees;
    EXPECT_NEAR(match.margin_angle, degrees < 10 ? decision::kNoCompetitor : 3, 1e-9);
    ASSERT_EQ(match.other_angle.has_value(), degrees >= 10);
    if (match.other_angle) {
      EXPECT_NEAR(angle_distance(*match.other_angle, match.pose.theta), to_radians(degrees), 1e-9);
    }
  }
}

TEST_F(DecisionTest, AnEquallyLikelyUnexplainedPlaceMakesAmbiguous) {
  const decision::Detection elsewhere = changed([](decision::Detection& d) {
    d.pose.x += 300;
    d.odds.best_at_place -= 2;
  });
  const Match alone = select({sound(), elsewhere}, std::nullopt, 1).matches.at(0);
  EXPECT_NEAR(alone.margin_place, 2, 1e-9);
  EXPECT_TRUE(alone.ambiguous);
  const decision::Selection both = select({sound(), elsewhere});
  ASSERT_EQ(both.matches.size(), 2u);
  for (const Match& match : both.matches) EXPECT_TRUE(match.graspable) << "an instance each";
  EXPECT_TRUE(both.rivals.empty());
}

TEST_F(DecisionTest, TheBetterOfTwoAtOnePlaceStays) {
  const decision::Detection shifted = changed([](decision::Detection& d) {
    d.pose.x += 3;
    d.odds.best_at_place += 1;
  });
  const decision::Selection selected = select({sound(), shifted});
  ASSERT_EQ(selected.matches.size(), 1u);
  EXPECT_NEAR(selected.matches[0].pose.x, match_of(shifted).pose.x, 1e-9);
}

TEST_F(DecisionTest, MapsThatShareMoreThanAQuarterClaimOnePlace) {
  const templates::MapFootprint& shape = object_.views.front().shape;
  double apart = 0;
  const auto common = [&] {
    return templates::overlap(shape, {100, 100, 0}, shape, {100 + apart, 100, 0});
  };
  while (common() > 0.5) ++apart;
  ASSERT_GT(common(), config_.max_overlap);
  const decision::Detection beside = changed([&](decision::Detection& d) {
    d.pose.x += apart;
    d.odds.best_at_place -= 1;
  });
  EXPECT_EQ(select({sound(), beside}).matches.size(), 1u);
}

TEST_F(DecisionTest, NoMoreInstancesThanAskedFor) {
  std::vector<decision::Detection> row;
  for (int k = 0; k < 4; ++k)
    row.push_back(changed([&](decision::Detection& d) { d.pose.x += 300 * k; }));
  EXPECT_EQ(select(row).matches.size(), 4u);
  EXPECT_EQ(select(row, std::nullopt, 3).matches.size(), 3u);
}

TEST_F(DecisionTest, MinScoreOfTheRequestPrecedesObjectAndConfig) {
  auto model = std::make_shared<ObjectModel>(*test::object_from(source_, {58, 60, 0}));
  model->min_score = 0.9;
  const prepared::PreparedObject choosy(model, prepared::Engine::kFast);
  decision::Detection detection = changed([](decision::Detection& d) { d.odds.best_at_place = 1; });
  const double score = match_of(detection).score;
  ASSERT_GT(score, config_.min_score);
  ASSERT_LT(score, 0.98);
  EXPECT_TRUE(select({detection}, 0.99).matches.empty());
  model->min_score = score + 0.01;
  detection.object = choosy.model.get();
  detection.view = &choosy.views.front();
  EXPECT_TRUE(select({detection}).matches.empty());
  EXPECT_EQ(select({detection}, 0.1).matches.size(), 1u);
}

TEST_F(DecisionTest, TheReferencePointMovesWithTheAnchorsAngleAndSize) {
  const prepared::PreparedObject off(test::object_from(source_, {98, 60, 0.5}),
                                     prepared::Engine::kFast);
  decision::Detection detection = sound();
  detection.object = off.model.get();
  detection.view = &off.views.front();
  detection.covariance = detection.grasp_covariance = cv::Matx33d::diag({0, 0, 1e-4});
  const Match match = match_of(detection);
  const cv::Point2d lever = match.pose.position() - detection.pose.position();
  ASSERT_GT(cv::norm(lever), 20);
  EXPECT_NEAR(match.covariance(0, 0), 1e-4 * lever.y * lever.y, 1e-9);
  EXPECT_NEAR(match.covariance(1, 1), 1e-4 * lever.x * lever.x, 1e-9);
  EXPECT_NEAR(match.covariance(1, 2), 1e-4 * lever.x, 1e-9);
  EXPECT_NEAR(match.covariance(0, 2), -1e-4 * lever.y, 1e-9);
  detection.scale = 1.1;
  const Match larger = match_of(detection);
  EXPECT_NEAR(cv::norm(larger.pose.position() - detection.pose.position()), 1.1 * cv::norm(lever),
              1e-9);
  EXPECT_NEAR(larger.scale, 1.1, 1e-9);
}

// Each view has its own crop, but all share the object's frame.
TEST_F(DecisionTest, AnglesOfTwoViewsAreComparedInTheObjectsFrame) {
  auto model = std::make_shared<ObjectModel>(*test::object_from(source_, {58, 60, 0}));
  model->views.push_back(test::object_from(source_, {58, 60, 1.2})->views.front());
  const prepared::PreparedObject two(model, prepared::Engine::kFast);
  ASSERT_EQ(two.views.size(), 2u);
  const auto seen = [&](int view, double object_angle, double log_odds) {
    decision::Detection detection = sound();
    detection.object = two.model.get();
    detection.view = &two.views[view];
    detection.pose.theta = object_angle - two.views[view].reference_in_anchor.theta;
    detection.odds.best_at_place = log_odds;
    return detection;
  };
  EXPECT_NEAR(select({seen(0, 0.3, 20), seen(1, 0.3, 17)}).matches.at(0).margin_angle,
              decision::kNoCompetitor, 1e-9);
  EXPECT_NEAR(select({seen(0, 0.3, 20), seen(1, 0.8, 17)}).matches.at(0).margin_angle, 3, 1e-9);
}

}  // namespace
}  // namespace mbncc
