// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/interactive_lesson.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "learning/images.hpp"

namespace mbncc {
namespace {

using test::draw_lesson;
using test::iou;
using test::map_of;

void expect_equal(const LearnResult& a, const LearnResult& b) {
  EXPECT_EQ(cv::norm(map_of(a), map_of(b), cv::NORM_INF), 0);
  EXPECT_EQ(a.object.views.front().reference.x, b.object.views.front().reference.x);
  EXPECT_EQ(a.object.views.front().reference.theta, b.object.views.front().reference.theta);
  EXPECT_EQ(a.object.quality.verdict, b.object.quality.verdict);
  EXPECT_EQ(a.object.quality.reasons, b.object.quality.reasons);
  EXPECT_EQ(a.object.quality.self_score, b.object.quality.self_score);
}

LessonEdit including(LessonEdit::Line line, double width = 5) {
  LessonEdit edit;
  edit.include = {std::move(line)};
  edit.stroke_width = width;
  return edit;
}

LessonEdit excluding(LessonEdit::Line line, double width = 5) {
  LessonEdit edit;
  edit.exclude = {std::move(line)};
  edit.stroke_width = width;
  return edit;
}

const LessonEdit::Line kInside{{100, 95}, {120, 100}, {140, 92}};
const LessonEdit::Line kOutside{{76, 66}, {100, 66}, {160, 66}};

// The guarantees of an edit hold for every way to obtain the first map.
class EditedLesson : public testing::TestWithParam<const char*> {
 protected:
  Lesson lesson() const {
    const auto drawn = draw_lesson();
    Lesson lesson = drawn.lesson;
    const std::string way = GetParam();
    if (way == "map") lesson.map = drawn.truth;
    if (way == "region" || way == "click") lesson.after = cv::Mat();
    if (way == "click" || way == "clicked change") {
      lesson.region = {};
      lesson.click = cv::Point2d(120, 100);
    }
    return lesson;
  }
};

TEST_P(EditedLesson, StartsWithTheResultOfLearnObject) {
  expect_equal(InteractiveLesson(lesson()).result(), learn_object(lesson()));
}

TEST_P(EditedLesson, ObeysTheStrokes) {
  InteractiveLesson edited(lesson());
  ASSERT_TRUE(edited.result().has_model);
  LessonEdit edit = including(kInside);
  edit.exclude = {kOutside};
  const LearnResult result = edited.edit(edit);
  ASSERT_TRUE(result.has_model) << result.message;
  for (const auto& point : kInside) EXPECT_EQ(map_of(result).at<uchar>(cv::Point(point)), 255);
  for (const auto& point : kOutside) EXPECT_EQ(map_of(result).at<uchar>(cv::Point(point)), 0);
}

TEST_P(EditedLesson, UndoRestoresBitForBit) {
  InteractiveLesson edited(lesson());
  const LearnResult first = edited.result();
  const LearnResult second = edited.edit(excluding({{90, 80}, {95, 120}}, 9));
  ASSERT_TRUE(second.has_model);
  edited.edit(including(kInside));
  EXPECT_TRUE(edited.undo());
  expect_equal(edited.result(), second);
  EXPECT_TRUE(edited.undo());
  expect_equal(edited.result(), first);
  EXPECT_FALSE(edited.undo());
}

TEST_P(EditedLesson, SameEditsGiveTheSameMap) {
  InteractiveLesson one(lesson()), other(lesson());
  for (InteractiveLesson* edited : {&one, &other}) {
    edited->edit(including(kInside));
    edited->edit(excluding(kOutside));
  }
  expect_equal(one.result(), other.result());
}

TEST_P(EditedLesson, EditsAddUp) {
  InteractiveLesson one(lesson()), two(lesson());
  LessonEdit both = including(kInside);
  both.exclude = {kOutside};
  one.edit(both);
  two.edit(including(kInside));
  two.edit(excluding(kOutside));
  expect_equal(one.result(), two.result());
}

TEST_P(EditedLesson, LaterStrokesWin) {
  InteractiveLesson edited(lesson());
  edited.edit(excluding(kInside));
  const LearnResult result = edited.edit(including(kInside));
  ASSERT_TRUE(result.has_model);
  for (const auto& point : kInside) EXPECT_EQ(map_of(result).at<uchar>(cv::Point(point)), 255);
}

TEST_P(EditedLesson, FailedEditChangesNothing) {
  InteractiveLesson edited(lesson());
  const LearnResult first = edited.result();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(edited.edit(including({{nan, 3}})).error, LearnError::kRegionInvalid);
  EXPECT_EQ(edited.edit(including(kInside, -1)).error, LearnError::kRegionInvalid);
  EXPECT_EQ(edited.edit(including({{5, 5}, {9, 9}}, 0)).error, LearnError::kRegionInvalid);
  EXPECT_EQ(edited.edit(including({{-40, 5}, {-9, 90}})).error, LearnError::kRegionInvalid);
  EXPECT_EQ(edited.edit(excluding({{5, 700}, {90, 900}})).error, LearnError::kRegionInvalid);
  EXPECT_EQ(edited.edit(including(LessonEdit::Line(5000, {9, 9}))).error,
            LearnError::kRegionInvalid);
  LessonEdit many_lines;
  many_lines.include.resize(5000);
  EXPECT_EQ(edited.edit(many_lines).error, LearnError::kRegionInvalid);
  LessonEdit nothing_left;
  nothing_left.exclude = {{{-1, -1}, {300, -1}, {300, 300}, {-1, 300}}};
  EXPECT_FALSE(edited.edit(nothing_left).has_model);
  expect_equal(edited.result(), first);
  EXPECT_FALSE(edited.undo());
}

INSTANTIATE_TEST_SUITE_P(Ways, EditedLesson,
                         testing::Values("change", "clicked change", "region", "map", "click"),
                         [](const auto& way) {
                           std::string name = way.param;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

TEST(InteractiveLesson, StrokesPaintOnAGivenMap) {
  const auto drawn = draw_lesson();
  Lesson lesson = drawn.lesson;
  lesson.map = drawn.truth;
  InteractiveLesson edited(lesson);
  LessonEdit edit;
  edit.include = {{{10, 10}, {30, 10}, {30, 20}, {10, 20}}};
  const cv::Mat map = map_of(edited.edit(edit));
  cv::Mat wanted = drawn.truth.clone();
  wanted(cv::Rect(10, 10, 21, 11)).setTo(255);
  EXPECT_EQ(cv::norm(map, wanted, cv::NORM_INF), 0);
}

TEST(InteractiveLesson, KeepsSixtyFourEditsToUndo) {
  auto drawn = draw_lesson();
  drawn.lesson.map = drawn.truth;
  InteractiveLesson edited(drawn.lesson);
  for (int i = 0; i < 70; ++i) {
    LessonEdit edit;
    edit.reference = Pose2D{double(i), 0, 0};
    ASSERT_TRUE(edited.edit(edit).has_model);
  }
  int undone = 0;
  while (edited.undo()) ++undone;
  EXPECT_EQ(undone, 64);
  EXPECT_EQ(edited.result().object.views[0].reference.x, 5);
}

TEST(InteractiveLesson, AReferenceEditMovesOnlyTheFrame) {
  InteractiveLesson edited(draw_lesson().lesson);
  const cv::Mat map = map_of(edited.result());
  LessonEdit edit;
  edit.reference = Pose2D{111, 99, 0.5};
  const LearnResult result = edited.edit(edit);
  EXPECT_EQ(result.object.views.front().reference.x, 111);
  EXPECT_EQ(cv::norm(map_of(result), map, cv::NORM_INF), 0);
}

TEST(InteractiveLesson, ANewRegionGivesANewCut) {
  const auto drawn = draw_lesson();
  Lesson lesson = drawn.lesson;
  lesson.region = {60, 60, 60, 50};  // cuts through the object
  InteractiveLesson edited(lesson);
  LessonEdit edit;
  edit.region = drawn.lesson.region;
  const LearnResult result = edited.edit(edit);
  ASSERT_TRUE(result.has_model);
  EXPECT_EQ(cv::norm(map_of(result), map_of(learn_object(drawn.lesson)), cv::NORM_INF), 0);
}

TEST(InteractiveLesson, AnExcludeStrokeRemovesAForeignObject) {
  auto drawn = draw_lesson();
  cv::Mat scene = drawn.scene.clone();
  cv::rectangle(scene, {130, 104, 30, 24}, cv::Scalar(40, 60, 45), cv::FILLED);  // a foreign object
  drawn.scene.copyTo(scene, drawn.truth);
  drawn.lesson.before = test::exposed(scene, 11);
  InteractiveLesson edited(drawn.lesson);
  LessonEdit edit;
  edit.exclude = {{{131, 113}, {153, 107}, {159, 107}, {159, 127}, {131, 127}}};
  const double before = iou(map_of(edited.result()), drawn.truth);
  const double after = iou(map_of(edited.edit(edit)), drawn.truth);
  EXPECT_LT(before, 0.85);
  EXPECT_GT(after, 0.9);
}

TEST(InteractiveLesson, AnEditDoesNotChangeTheFirstCut) {
  const auto drawn = draw_lesson();
  InteractiveLesson one(drawn.lesson), other(drawn.lesson);
  one.edit(including({{60, 50}, {66, 50}}));
  one.undo();
  one.edit(excluding(kOutside));
  other.edit(excluding(kOutside));
  expect_equal(one.result(), other.result());
}

TEST(InteractiveLesson, AFailedLessonCannotBeEdited) {
  auto drawn = draw_lesson();
  drawn.lesson.before = drawn.lesson.after;
  InteractiveLesson edited(drawn.lesson);
  ASSERT_FALSE(edited.result().has_model);
  EXPECT_EQ(edited.edit(including(kInside)).error, LearnError::kRegionInvalid);
}

}  // namespace
}  // namespace mbncc
