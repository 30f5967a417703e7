// SPDX-License-Identifier: BSD-3-Clause
// Lessons that are refused because of their input or their result.
#include "mbncc/learning/learn_object.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "learning/images.hpp"
#include "mbncc/learning/interactive_lesson.hpp"

namespace mbncc {
namespace {

using test::draw_lesson;
using test::DrawnLesson;

using test::error_for;

TEST(LearnErrors, BadName) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.name = "../x";
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kNameInvalid);
}

TEST(LearnErrors, NoImage) {
  DrawnLesson drawn = draw_lesson();
  for (const cv::Mat& useless : {cv::Mat(), cv::Mat(20, 20, CV_8UC3), cv::Mat(100, 100, CV_8UC1),
                                 cv::Mat(100, 100, CV_16UC3)}) {
    drawn.lesson.before = useless;
    EXPECT_EQ(error_for(drawn.lesson), LearnError::kNoImage);
  }
}

TEST(LearnErrors, ImageMismatch) {
  DrawnLesson drawn = draw_lesson();
  Lesson lesson = drawn.lesson;
  lesson.after = drawn.lesson.after(cv::Rect(0, 0, 100, 100));
  EXPECT_EQ(error_for(lesson), LearnError::kImageMismatch);
  lesson = drawn.lesson;
  lesson.map = cv::Mat(100, 100, CV_8UC1, cv::Scalar(255));
  EXPECT_EQ(error_for(lesson), LearnError::kImageMismatch);
  lesson.map = cv::Mat(drawn.truth.size(), CV_8UC3);
  EXPECT_EQ(error_for(lesson), LearnError::kImageMismatch);
}

TEST(LearnErrors, ChangeCutNeedsAnImageAfter) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after = cv::Mat();
  LearningConfig config;
  config.method = "change_cut";
  EXPECT_EQ(learn_object(drawn.lesson, config).error, LearnError::kNoImage);
}

TEST(LearnErrors, ObjectPlaceIsNotGiven) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after = cv::Mat();
  drawn.lesson.region = {};
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kRegionInvalid);
}

TEST(LearnErrors, ReferencesThatAreNotNumbers) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  DrawnLesson drawn = draw_lesson();
  for (const Pose2D& nonsense : {Pose2D{kNan, 100, 0}, {120, -kInfinity, 0}, {120, 100, kNan}}) {
    drawn.lesson.reference = nonsense;
    EXPECT_EQ(error_for(drawn.lesson), LearnError::kRegionInvalid);
  }
}

TEST(LearnErrors, SymmetryThatCannotBeDeclared) {
  DrawnLesson drawn = draw_lesson();
  for (const int symmetry : {-1, 13, 255}) {
    drawn.lesson.symmetry = symmetry;
    EXPECT_EQ(error_for(drawn.lesson), LearnError::kRegionInvalid) << symmetry;
  }
}

TEST(LearnErrors, RegionInvalid) {
  DrawnLesson drawn = draw_lesson();
  const int huge = std::numeric_limits<int>::max();
  for (const cv::Rect& region :
       {cv::Rect(10, 10, 0, 20), cv::Rect(10, 10, -5, 20), cv::Rect(300, 10, 50, 50),
        cv::Rect(-60, 0, 50, 50), cv::Rect(0, 0, 7, 7), cv::Rect(huge, huge, huge, huge),
        cv::Rect(-huge, -huge, huge, huge)}) {
    drawn.lesson.region = region;
    EXPECT_EQ(error_for(drawn.lesson), LearnError::kRegionInvalid) << region;
  }
}

TEST(LearnErrors, RegionReachingOverTheBorderIsClipped) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.region.width = std::numeric_limits<int>::max();
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kSuccess);
}

TEST(LearnErrors, OutlineInvalid) {
  DrawnLesson drawn = draw_lesson();
  const float none = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::vector<cv::Point2f>> outlines{{{10, 10}, {50, 10}},
                                                       {{10, 10}, {50, none}, {20, 60}},
                                                       {{10, 10}, {60, 60}, {60, 10}, {10, 60}},
                                                       {{1000, 1000}, {1100, 1000}, {1050, 1100}},
                                                       {{10, 10}, {1e9F, 10}, {20, 60}},
                                                       std::vector<cv::Point2f>(5000, {10, 10})};
  for (const auto& outline : outlines) {
    drawn.lesson.outline = outline;
    EXPECT_EQ(error_for(drawn.lesson), LearnError::kRegionInvalid);
  }
}

TEST(LearnErrors, MapEmptyOrFull) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.map = cv::Mat::zeros(drawn.truth.size(), CV_8UC1);
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kSegmentationEmpty);
  drawn.lesson.map.setTo(255);
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kSegmentationFull);
}

TEST(LearnErrors, OutlineOfTheWholeImage) {
  DrawnLesson drawn = draw_lesson();
  const auto right = static_cast<float>(drawn.truth.cols),
             low = static_cast<float>(drawn.truth.rows);
  drawn.lesson.outline = {{0, 0}, {right, 0}, {right, low}, {0, low}};
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kSegmentationFull);
}

// A stroke over everything leaves no map.
TEST(LearnErrors, StrokeThatExcludesTheWholeObject) {
  InteractiveLesson lesson(draw_lesson().lesson);
  LessonEdit edit;
  edit.exclude = {{{0, 100}, {239, 100}}};
  edit.stroke_width = 200;
  EXPECT_EQ(lesson.edit(edit).error, LearnError::kSegmentationEmpty);
}

// The message that a person reads about a refused lesson.
std::string told(const Lesson& lesson) {
  const LearnResult result = learn_object(lesson);
  return result.message + " " + result.hint;
}

TEST(LearnErrors, MessagesNameTheInputAndTheRemedy) {
  DrawnLesson drawn = draw_lesson();
  Lesson lesson = drawn.lesson;
  const std::string size =
      std::to_string(lesson.before.cols) + " x " + std::to_string(lesson.before.rows);
  lesson.map = cv::Mat::zeros(drawn.truth.size(), CV_8UC1);
  EXPECT_EQ(told(lesson), "The map is black everywhere. Paint the object white.");
  lesson.map.setTo(255);
  EXPECT_EQ(told(lesson),
            "The map is white nearly everywhere. Paint everything but the object black.");
  lesson = drawn.lesson;
  lesson.click = cv::Point2d(-1, 5);
  EXPECT_EQ(told(lesson),
            "The click does not lie in the image. Give a point inside the image "
            "of " +
                size + " px.");
  lesson = drawn.lesson;
  lesson.region = {100, 90, 5, 5};
  EXPECT_EQ(told(lesson), "The region is only 5 x 5 px. Give at least 8 x 8 px.");
  lesson.region = {1000, 90, 50, 50};
  EXPECT_EQ(
      told(lesson),
      "The region does not lie in the image. Give a region inside the image of " + size + " px.");
  lesson.region = {5, 5, 20, 20};
  EXPECT_EQ(told(lesson),
            "The images before and after show no difference in the region. Draw the region around "
            "the place where the object lay.");
  lesson.region = {};
  std::swap(lesson.before, lesson.after);
  EXPECT_NE(told(lesson).find("exchange before and after"), std::string::npos);
  lesson = drawn.lesson;
  lesson.region = {{0, 0}, lesson.before.size()};
  EXPECT_EQ(learn_object(lesson).error, LearnError::kSuccess) << "the change shows the object";
  lesson.after = cv::Mat();
  EXPECT_EQ(told(lesson), "The region is the whole image. Draw it close around the object.");
}

TEST(LearnErrors, ARegionInsideTheObjectIsReported) {
  DrawnLesson drawn = draw_lesson({160, 120}, {320, 240});
  Lesson lesson = drawn.lesson;
  lesson.after = cv::Mat();
  for (const int side : {40, 50}) {
    lesson.region = {160 - side / 2, 120 - side / 2, side, side};
    EXPECT_EQ(learn_object(lesson).error, LearnError::kQualityBad);
    EXPECT_EQ(learn_object(lesson).hint, "The region may cut the object off: draw it larger.");
  }
}

TEST(LearnErrors, MessageDistinguishesAClickOnThePlatform) {
  DrawnLesson drawn = draw_lesson({30, 100});
  drawn.lesson.region = {};
  drawn.lesson.click = cv::Point2d(30, 100);
  EXPECT_EQ(told(drawn.lesson).find("What was clicked"), std::string::npos);
  drawn.lesson.after = cv::Mat();
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_EQ(result.error, LearnError::kTouchesBorder);
  EXPECT_EQ(result.message, "What was clicked reaches the image's border.");
}

TEST(LearnErrors, TouchesBorder) {
  const DrawnLesson drawn = draw_lesson({30, 100});
  const LearnResult result = learn_object(drawn.lesson);
  EXPECT_EQ(result.error, LearnError::kTouchesBorder);
  EXPECT_TRUE(result.has_model) << "the caller may store it all the same";
  EXPECT_EQ(result.object.quality.verdict, Verdict::kBad);
  EXPECT_EQ(result.object.quality.reasons.front(), "touches_image_border");
  EXPECT_EQ(result.hint, result.object.quality.advice.front());
}

TEST(LearnErrors, MessageDistinguishesARegionBeyondTheBorder) {
  DrawnLesson drawn = draw_lesson({30, 100});
  drawn.lesson.region = {-40, 40, 130, 130};
  const LearnResult result = learn_object(drawn.lesson);
  EXPECT_EQ(result.error, LearnError::kRegionInvalid);
  EXPECT_NE(result.message.find("reaches out of the image"), std::string::npos);
}

TEST(LearnErrors, TooSmall) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after = cv::Mat();
  drawn.lesson.outline = {{100, 100}, {107, 100}, {107, 107}, {100, 107}};
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kTooSmall);
}

TEST(LearnErrors, LowTexture) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after = cv::Mat();
  drawn.lesson.before = cv::Mat(drawn.truth.size(), CV_8UC3, cv::Scalar(100, 100, 100));
  drawn.lesson.outline = {{80, 70}, {160, 70}, {160, 130}, {80, 130}};
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kLowTexture);
  const LearnResult result = learn_object(drawn.lesson);
  EXPECT_EQ(result.hint, result.object.quality.advice.front());
  EXPECT_NE(result.hint, hint_of(result.error)) << "the reason's own";
}

}  // namespace
}  // namespace mbncc
