// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/scene_watch.hpp"

#include <gtest/gtest.h>

#include "mbncc/cell/scene_difference.hpp"
#include "mbncc/sim/cell_script.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc {
namespace {

constexpr double kFrameTime = 0.1;  // [s]

/// A small simulated cell whose images go to a watch.
class Cell {
 public:
  explicit Cell(double noise = 3) : scene_(scene_config(noise)), script_(script_config()) {}

  /// Passes the next `count` images of the script to the watch.
  void show(int count, std::optional<double> gain = {}) {
    for (int i = 0; i < count; ++i) {
      const sim::CellFrame frame = script_.frame();
      show_image(scene_.render(frame.placed, frames_, frame.arm) * gain.value_or(1));
      script_.step();
    }
  }

  /// Shows the rest of the script's current motion.
  void show_motion() {
    while (!script_.at_rest()) show(1);
  }

  /// Shows the resting cell with an arm reaching over it.
  void show_arm(int count, cv::Point2d grip) {
    for (int i = 0; i < count; ++i)
      show_image(
          scene_.render(script_.frame().placed, frames_, sim::Arm{{grip.x, grip.y, -kPi / 2}}));
  }

  void show_image(const cv::Mat& image) {
    watch.update(1000 + kFrameTime * static_cast<double>(frames_++), image);
  }

  cv::Mat image_at_rest() const { return scene_.render(script_.frame().placed, 12345); }

  SceneWatch watch{0.5};
  sim::CellScript& script() { return script_; }

 private:
  static sim::SceneConfig scene_config(double noise) {
    sim::SceneConfig config;
    config.size = {320, 240};
    config.noise_sigma = noise;
    return config;
  }
  static sim::CellScriptConfig script_config() {
    sim::CellScriptConfig config;
    config.size = {320, 240};
    config.object.diameter = 45;
    config.auto_play = false;
    config.leg_frames = 8;
    return config;
  }

  sim::Scene scene_;
  sim::CellScript script_;
  std::uint64_t frames_ = 0;
};

TEST(SceneWatch, BecomesStillAfterTheStillTime) {
  Cell cell;
  cell.show(5);
  EXPECT_FALSE(cell.watch.still());
  cell.show(2);
  ASSERT_TRUE(cell.watch.still());
  EXPECT_EQ(cell.watch.still()->number, 1u);
  EXPECT_FALSE(cell.watch.before_change());
}

// The newest images may already show the beginning of the next motion.
TEST(SceneWatch, NeverHandsOverTheNewestImages) {
  constexpr double kStill = 1;
  SceneWatch watch(kStill);
  const cv::Mat image(60, 80, CV_8UC3, cv::Scalar::all(100));
  double first = 0;
  for (double stamp = 10; stamp < 16; stamp += 0.1) {
    watch.update(stamp, image);
    if (!watch.still()) continue;
    if (first == 0) first = stamp;
    EXPECT_LE(watch.still()->stamp, std::max(first, stamp - kStill / 2) + 1e-9) << stamp;
  }
  EXPECT_GT(watch.still()->stamp, first) << "it is renewed";
}

TEST(SceneWatch, StaysStillUnderNoiseAndFlicker) {
  Cell cell(9);
  for (int i = 0; i < 40; ++i) cell.show(1, 1 + 0.04 * (i % 3 - 1));
  ASSERT_TRUE(cell.watch.still());
  EXPECT_EQ(cell.watch.still()->number, 1u);
}

TEST(SceneWatch, HandsOverBeforeAndAfter) {
  Cell cell;
  cell.show(10);
  const cv::Mat before_truth = cell.image_at_rest();
  ASSERT_TRUE(cell.script().take_away());
  cell.show(6);
  EXPECT_FALSE(cell.watch.still());
  EXPECT_FALSE(cell.watch.before_change());
  cell.show_motion();
  cell.show(10);
  ASSERT_TRUE(cell.watch.still());
  const auto before = cell.watch.before_change();
  ASSERT_TRUE(before);
  EXPECT_LT(before->number, cell.watch.still()->number);
  EXPECT_EQ(scene_change(before->image, before_truth), SceneChange::kNone);
  EXPECT_EQ(scene_change(cell.watch.still()->image, cell.image_at_rest()), SceneChange::kNone);
  EXPECT_EQ(scene_change(before->image, cell.watch.still()->image), SceneChange::kInside);
}

TEST(SceneWatch, StillImagesShowNothingOfTheMotion) {
  for (std::uint64_t start = 0; start < 5; ++start) {
    Cell cell(0);
    cell.show(10 + static_cast<int>(start));
    const cv::Mat truth = cell.image_at_rest();
    ASSERT_TRUE(cell.script().take_away());
    cell.show_motion();
    cell.show(10);
    ASSERT_TRUE(cell.watch.before_change());
    EXPECT_EQ(cv::norm(cell.watch.before_change()->image, truth, cv::NORM_INF), 0);
  }
}

TEST(SceneWatch, ArmThatEntersAndLeavesIsNoChange) {
  Cell cell;
  cell.show(10);
  const std::uint64_t number = cell.watch.still()->number;
  for (int y = 300; y > 100; y -= 40) cell.show_arm(1, {160.0, double(y)});
  EXPECT_FALSE(cell.watch.still());
  for (int y = 100; y < 300; y += 40) cell.show_arm(1, {160.0, double(y)});
  cell.show(10);
  ASSERT_TRUE(cell.watch.still());
  EXPECT_GT(cell.watch.still()->number, number);
  EXPECT_FALSE(cell.watch.before_change());
}

TEST(SceneWatch, PausingArmIsDetectedAtTheBorder) {
  Cell cell;
  cell.show(10);
  const cv::Mat before = cell.watch.still()->image;
  for (int y = 300; y > 100; y -= 40) cell.show_arm(1, {160.0, double(y)});
  cell.show_arm(10, {160.0, 100.0});
  ASSERT_TRUE(cell.watch.still()) << "the arm pauses";
  EXPECT_EQ(scene_change(before, cell.watch.still()->image), SceneChange::kAtBorder);
  EXPECT_FALSE(cell.watch.before_change());
}

TEST(SceneWatch, BeforeChangeSkipsThePausingArm) {
  Cell cell;
  cell.show(10);
  const cv::Mat truth = cell.image_at_rest();
  for (int y = 300; y > 100; y -= 40) cell.show_arm(1, {160.0, double(y)});
  cell.show_arm(10, {160.0, 100.0});
  ASSERT_TRUE(cell.watch.still());
  ASSERT_TRUE(cell.script().take_away());
  cell.show_motion();
  cell.show(10);
  ASSERT_TRUE(cell.watch.before_change());
  EXPECT_EQ(scene_change(cell.watch.before_change()->image, truth), SceneChange::kNone);
}

TEST(SceneWatch, SlowMotionAddsUp) {
  Cell cell(1);
  cell.show(10);
  ASSERT_TRUE(cell.watch.still());
  for (int i = 0; i < 60; ++i) cell.show_arm(1, {160.0, 330.0 - 2 * i});
  EXPECT_FALSE(cell.watch.still());
}

TEST(SceneWatch, ClockJumpAndNewSizeRestartTheWatch) {
  Cell cell;
  cell.show(10);
  ASSERT_TRUE(cell.watch.still());
  cell.watch.update(5, cell.image_at_rest());
  EXPECT_FALSE(cell.watch.still());
  cell.watch.update(6, cell.image_at_rest());
  ASSERT_TRUE(cell.watch.still());
  EXPECT_EQ(cell.watch.still()->number, 2u) << "numbers go on";
  EXPECT_FALSE(cell.watch.before_change());
  cell.watch.update(7, cell.image_at_rest()(cv::Rect(0, 0, 300, 200)));
  EXPECT_FALSE(cell.watch.still());
}

TEST(SceneWatch, LargeImagesAreWatchedAsSmallOnes) {
  const cv::Size size(2592, 1944);
  cv::Mat before(size, CV_8UC3), after;
  cv::theRNG().state = 3;
  cv::randu(before, 90, 110);
  before.copyTo(after);
  after(cv::Rect(1200, 900, 300, 300)).setTo(cv::Scalar(40, 160, 200));
  SceneWatch watch(0.3);
  double now = 1000;
  const auto show = [&](const cv::Mat& image) {
    for (int i = 0; i < 6; ++i) watch.update(now += kFrameTime, image);
  };
  show(before);
  ASSERT_TRUE(watch.still());
  EXPECT_EQ(watch.still()->image.size(), size);
  show(after);
  ASSERT_TRUE(watch.still());
  EXPECT_EQ(watch.still()->number, 2u) << "the change was seen";
  ASSERT_TRUE(watch.before_change());
  EXPECT_EQ(cv::norm(watch.before_change()->image, before, cv::NORM_INF), 0);
}

TEST(SceneWatch, RefusesUnusableImages) {
  SceneWatch watch;
  EXPECT_THROW(watch.update(1, cv::Mat()), std::invalid_argument);
  EXPECT_THROW(watch.update(1, cv::Mat(10, 10, CV_8UC1)), std::invalid_argument);
  EXPECT_THROW(SceneWatch(0), std::invalid_argument);
}

}  // namespace
}  // namespace mbncc
