// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/sim/cell_script.hpp"

#include <gtest/gtest.h>

namespace mbncc::sim {
namespace {

CellScriptConfig on_request() {
  CellScriptConfig config;
  config.auto_play = false;
  config.leg_frames = 5;
  return config;
}

void walk_to_rest(CellScript& script) {
  for (int i = 0; i < 100 && !script.at_rest(); ++i) script.step();
  ASSERT_TRUE(script.at_rest());
}

bool same(const Pose2D& a, const Pose2D& b) {
  return a.x == b.x && a.y == b.y && a.theta == b.theta;
}

TEST(CellScript, BeginsAtRestInTheMiddle) {
  const CellFrame frame = CellScript(on_request()).frame();
  EXPECT_EQ(frame.phase, CellPhase::kRest);
  EXPECT_FALSE(frame.arm);
  ASSERT_TRUE(frame.truth);
  EXPECT_TRUE(same(*frame.truth, {320, 240, 0}));
  EXPECT_EQ(frame.placed.size(), 3u);
}

TEST(CellScript, RestsUntilACommand) {
  CellScript script(on_request());
  for (int i = 0; i < 500; ++i) script.step();
  EXPECT_TRUE(script.at_rest());
}

TEST(CellScript, TakeAwayLeavesTheNeighboursOnly) {
  CellScript script(on_request());
  ASSERT_TRUE(script.take_away());
  EXPECT_FALSE(script.take_away()) << "under way already";
  EXPECT_FALSE(script.put_next());
  EXPECT_EQ(script.frame().phase, CellPhase::kReach);
  EXPECT_TRUE(script.frame().truth);
  walk_to_rest(script);
  EXPECT_FALSE(script.frame().truth);
  EXPECT_EQ(script.frame().placed.size(), 2u);
  EXPECT_FALSE(script.take_away()) << "nothing lies there";
}

TEST(CellScript, PutNextPutsTheObjectElsewhereAndTurned) {
  CellScript script(on_request());
  std::optional<Pose2D> last = script.frame().truth;
  for (int i = 0; i < 10; ++i) {
    if (i % 2 == 1) {
      ASSERT_TRUE(script.take_away());
      walk_to_rest(script);
    }
    ASSERT_TRUE(script.put_next());
    walk_to_rest(script);
    const auto truth = script.frame().truth;
    ASSERT_TRUE(truth);
    EXPECT_GT(std::abs(truth->x - last->x) + std::abs(truth->y - last->y), 0.5);
    EXPECT_GT(angle_distance(truth->theta, last->theta), 0.001);
    last = truth;
  }
}

TEST(CellScript, ObjectMovesWithoutJumps) {
  CellScriptConfig config = on_request();
  config.leg_frames = 60;
  CellScript script(config);
  ASSERT_TRUE(script.put_next());
  Pose2D last = script.frame().placed.back().pose;
  const CellFrame reach = script.frame();
  while (!script.at_rest()) {
    script.step();
    const CellFrame frame = script.frame();
    ASSERT_EQ(frame.placed.size(), reach.placed.size());
    const Pose2D pose = frame.placed.back().pose;
    EXPECT_LT(cv::norm(pose.position() - last.position()), 25);
    EXPECT_LT(angle_distance(pose.theta, last.theta), 0.2);
    last = pose;
  }
  EXPECT_TRUE(same(last, *script.frame().truth));
}

TEST(CellScript, NoTruthWhileCarried) {
  CellScript script(on_request());
  ASSERT_TRUE(script.put_next());
  int carried = 0;
  while (!script.at_rest()) {
    const CellFrame frame = script.frame();
    EXPECT_EQ(frame.truth.has_value(), frame.phase != CellPhase::kCarry);
    EXPECT_TRUE(frame.arm);
    carried += frame.phase == CellPhase::kCarry;
    script.step();
  }
  EXPECT_EQ(carried, 5);
}

TEST(CellScript, WaitingArmAndRemovedObjectAreOutsideTheImage) {
  CellScriptConfig config = on_request();
  config.leg_frames = 50;
  CellScript script(config);
  script.take_away();
  SceneConfig scene_config;
  scene_config.noise_sigma = 0;
  const Scene scene(scene_config);
  const cv::Mat before = scene.render(script.frame().placed);
  const CellFrame first = script.frame();
  EXPECT_LT(cv::norm(scene.render(first.placed, 0, first.arm), before, cv::NORM_INF), 2);
  CellFrame last;
  for (; !script.at_rest(); script.step()) last = script.frame();
  const cv::Mat after = scene.render(script.frame().placed);
  EXPECT_LT(cv::norm(scene.render(last.placed, 0, last.arm), after, cv::NORM_INF), 2);
}

TEST(CellScript, PlacesAreInsideAndClearOfTheNeighbours) {
  for (std::uint64_t seed = 1; seed < 10; ++seed) {
    CellScriptConfig config = on_request();
    config.seed = seed;
    CellScript script(config);
    const Scene scene;
    for (int i = 0; i < 10; ++i) {
      ASSERT_TRUE(script.put_next());
      walk_to_rest(script);
      const CellFrame frame = script.frame();
      cv::Mat map = scene.true_map(frame.placed.back());
      EXPECT_EQ(cv::countNonZero(map.row(0)) + cv::countNonZero(map.row(map.rows - 1)) +
                    cv::countNonZero(map.col(0)) + cv::countNonZero(map.col(map.cols - 1)),
                0);
      for (std::size_t k = 0; k + 1 < frame.placed.size(); ++k)
        EXPECT_EQ(cv::countNonZero(map & scene.true_map(frame.placed[k])), 0);
    }
  }
}

TEST(CellScript, RunsAutomatically) {
  CellScriptConfig config;
  config.rest_frames = 4;
  config.leg_frames = 3;
  CellScript script(config);
  int lying = 0, empty = 0;
  bool was_at_rest = false;
  for (int i = 0; i < 200; ++i, script.step()) {
    const bool arrives = script.at_rest() && !was_at_rest;
    if (arrives) script.frame().truth ? ++lying : ++empty;
    was_at_rest = script.at_rest();
  }
  EXPECT_GE(lying, 8);
  EXPECT_GE(empty, 8);
}

TEST(CellScript, SameSeedSameStory) {
  CellScript a, b;
  for (int i = 0; i < 300; ++i, a.step(), b.step()) {
    ASSERT_EQ(a.frame().placed.size(), b.frame().placed.size());
    EXPECT_TRUE(same(a.frame().placed.back().pose, b.frame().placed.back().pose));
  }
}

TEST(CellScript, RefusesObjectsThatDoNotFit) {
  CellScriptConfig config;
  config.object.diameter = 450;
  config.neighbours = 0;
  EXPECT_THROW(CellScript{config}, std::invalid_argument);
  CellScriptConfig crowded;
  crowded.neighbours = 200;
  EXPECT_THROW(CellScript{crowded}, std::invalid_argument);
}

}  // namespace
}  // namespace mbncc::sim
