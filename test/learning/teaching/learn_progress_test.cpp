// SPDX-License-Identifier: BSD-3-Clause
// Reports to a lesson's observer, and cancellation by the observer.
#include "mbncc/learning/learn_object.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"

namespace mbncc {
namespace {

using test::draw_lesson;
using test::DrawnLesson;

TEST(LearnObject, ReportsStagesInOrderWithRisingProgress) {
  const DrawnLesson drawn = draw_lesson();
  Stage last_stage = Stage::kRegion;
  double last_progress = 0;
  int images = 0;
  learn_object(drawn.lesson, {}, {},
               [&](Stage stage, double progress, const std::string& message, const cv::Mat& step) {
                 EXPECT_GE(stage, last_stage);
                 EXPECT_GE(progress, last_progress);
                 EXPECT_FALSE(message.empty());
                 if (!step.empty()) {
                   EXPECT_EQ(step.type(), CV_8UC3);
                   ++images;
                 }
                 last_stage = stage;
                 last_progress = progress;
                 return true;
               });
  EXPECT_EQ(last_stage, Stage::kQuality);
  EXPECT_EQ(last_progress, 1);
  EXPECT_GE(images, 3);
}

TEST(LearnObject, CanBeCancelledAtEveryStep) {
  const DrawnLesson drawn = draw_lesson();
  int steps = 0;
  learn_object(drawn.lesson, {}, {}, [&](auto&&...) { return ++steps, true; });
  ASSERT_GT(steps, 3);
  for (int stop = 1; stop <= steps; ++stop) {
    int step = 0;
    const LearnResult result =
        learn_object(drawn.lesson, {}, {}, [&](auto&&...) { return ++step < stop; });
    EXPECT_EQ(result.error, LearnError::kCancelled);
    EXPECT_FALSE(result.has_model);
    EXPECT_EQ(step, stop) << "the observer heard of a step after cancelling";
  }
}

}  // namespace
}  // namespace mbncc
