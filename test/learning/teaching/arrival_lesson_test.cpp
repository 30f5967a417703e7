// SPDX-License-Identifier: BSD-3-Clause
// Lessons without a region in which something was put down: only the removed object may be learned.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <utility>

#include "mbncc/learning/learn_object.hpp"
#include "mbncc/sim/cell_script.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc {
namespace {

class Arrival : public testing::TestWithParam<int> {
 protected:
  Arrival() : script_(script_config()) { lesson_.name = "thing"; }

  static sim::CellScriptConfig script_config() {
    sim::CellScriptConfig config;
    config.auto_play = false;
    config.leg_frames = 1;
    config.object.seed = static_cast<std::uint64_t>(GetParam());
    return config;
  }

  cv::Mat image() {
    while (!script_.at_rest()) script_.step();
    return scene_.render(script_.frame().placed, frame_++);
  }

  cv::Mat true_map() { return scene_.true_map(script_.frame().placed.back()); }

  sim::Scene scene_;
  sim::CellScript script_;
  std::uint64_t frame_ = 0;
  Lesson lesson_;
};

TEST_P(Arrival, AnObjectThatWasPutDownIsNotLearned) {
  script_.take_away();
  lesson_.before = image();
  script_.put_next();
  lesson_.after = image();
  const LearnResult result = learn_object(lesson_);
  EXPECT_EQ(result.error, LearnError::kNoChange);
  EXPECT_FALSE(result.has_model);
}

TEST_P(Arrival, AnObjectPutAsideIsLearnedWhereItLay) {
  lesson_.before = image();
  const cv::Mat truth = true_map();
  script_.put_next();
  lesson_.after = image();
  const LearnResult result = learn_object(lesson_);
  ASSERT_TRUE(result.has_model) << result.message;
  const cv::Mat map = full_size_map(result.object.views.front());
  EXPECT_GT(cv::countNonZero(map & truth), 0.9 * cv::countNonZero(map | truth));
}

TEST_P(Arrival, InterchangedImagesAreNoGoodLesson) {
  lesson_.after = image();
  lesson_.region = cv::boundingRect(true_map());
  lesson_.region -= cv::Point(15, 15);
  lesson_.region += cv::Size(30, 30);
  script_.take_away();
  lesson_.before = image();
  const LearnResult interchanged = learn_object(lesson_);
  EXPECT_NE(interchanged.object.quality.verdict, Verdict::kGood);
  if (interchanged.has_model) {
    EXPECT_GT(interchanged.evidence->edges_after, 0.2);
  }
  std::swap(lesson_.before, lesson_.after);
  const LearnResult right = learn_object(lesson_);
  ASSERT_TRUE(right.has_model) << right.message;
  EXPECT_LT(right.evidence->edges_after, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Arrival, testing::Values(1, 2, 3, 4));

}  // namespace
}  // namespace mbncc
