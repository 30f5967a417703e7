// SPDX-License-Identifier: BSD-3-Clause
// Lessons in which the object is put aside within the view.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "learning/images.hpp"
#include "learning/teaching/put_aside.hpp"
#include "learning/teaching/segmenter.hpp"
#include "mbncc/learning/change.hpp"
#include "mbncc/learning/interactive_lesson.hpp"

namespace mbncc {
namespace {

const cv::Size kSize(340, 240);
const cv::Point kOldPlace(80, 110);

class PutAside : public testing::TestWithParam<double> {
 protected:
  PutAside() : drawn_(test::draw_lesson(kOldPlace, kSize)) {
    const double theta = to_radians(GetParam());
    motion_ = compose(Pose2D{250.3, 120.6, theta}, Pose2D{-80, -110, 0});
    const double c = std::cos(theta), s = std::sin(theta);
    const cv::Matx23d matrix(c, -s, motion_.x, s, c, motion_.y);
    cv::Mat scene = drawn_.platform.clone(), object, cover;
    cv::warpAffine(drawn_.scene, object, matrix, kSize, cv::INTER_CUBIC);
    cv::warpAffine(drawn_.truth, cover, matrix, kSize, cv::INTER_LINEAR);
    object.copyTo(scene, cover > 127);
    cv::GaussianBlur(scene, scene, {}, 0.7);
    drawn_.lesson.after = test::exposed(scene, 12);
  }

  void expect_at_new_place(const LearnResult& result) const {
    ASSERT_TRUE(result.put_aside) << result.message;
    const Pose2D truth = compose(motion_, result.object.views.front().reference);
    EXPECT_NEAR(result.put_aside->pose.x, truth.x, 1);
    EXPECT_NEAR(result.put_aside->pose.y, truth.y, 1);
    EXPECT_LT(angle_distance(result.put_aside->pose.theta, truth.theta), to_radians(1));
    EXPECT_GT(result.put_aside->agreement, 0.75);
    EXPECT_TRUE(result.put_aside->refined);
  }

  double quality(const LearnResult& result) const {
    return test::iou(test::map_of(result), drawn_.truth);
  }

  test::DrawnLesson drawn_;
  Pose2D motion_;  // of the object, from before to after
};

TEST_P(PutAside, IsFoundAtItsNewPlace) {
  const LearnResult result = learn_object(drawn_.lesson);
  expect_at_new_place(result);
  EXPECT_GT(quality(result), 0.93);
}

// What lies beyond the border of the image after says nothing about the map.
TEST(PutAsideLesson, APartOutOfViewIsNoPlatform) {
  const auto drawn = test::draw_lesson(kOldPlace, kSize);
  const double way = kSize.width - 10 - kOldPlace.x;
  cv::Mat after = drawn.platform.clone(), moved, cover;
  const cv::Matx23d shift(1, 0, way, 0, 1, 20);
  cv::warpAffine(drawn.scene, moved, shift, kSize);
  cv::warpAffine(drawn.truth, cover, shift, kSize, cv::INTER_NEAREST);
  moved.copyTo(after, cover);
  Lesson lesson = drawn.lesson;
  lesson.after = test::exposed(after, 12);
  const LearnResult learned = learn_object(lesson);
  ASSERT_TRUE(learned.put_aside) << learned.message;
  teaching::SegmentationTask task{lesson.before, lesson.after, lesson.region, drawn.truth,
                                  survey_change(lesson.before, lesson.after).changed};
  const auto found = teaching::find_put_aside(learned.object, drawn.truth, task, task.changed,
                                              LearningConfig(), SearchConfig());
  ASSERT_TRUE(found);
  const int beyond = static_cast<int>(kSize.width - way) + 3;
  ASSERT_GT(cv::countNonZero(drawn.truth.colRange(beyond, kSize.width)), 300);
  EXPECT_EQ(cv::norm(found->preference.colRange(beyond, kSize.width), cv::NORM_INF), 0);
}

TEST_P(PutAside, IsFoundWithoutARegion) {
  drawn_.lesson.region = {};
  const LearnResult result = learn_object(drawn_.lesson);
  expect_at_new_place(result);
  EXPECT_GT(quality(result), 0.93);
}

TEST_P(PutAside, ThePoseIsThatOfTheObjectFrame) {
  drawn_.lesson.reference = Pose2D{20, 30, 0.4};
  expect_at_new_place(learn_object(drawn_.lesson));
}

TEST_P(PutAside, IsKeptThroughEdits) {
  InteractiveLesson edited(drawn_.lesson);
  LessonEdit edit;
  edit.include = {{{80, 110}, {90, 110}}};
  edit.stroke_width = 4;
  edit.reference = Pose2D{70, 100, -1};
  expect_at_new_place(edited.edit(edit));
}

// If the object is partly hidden now, the map from its old place must not be refined.
TEST_P(PutAside, DoesNotRefineIfTheMapsDisagree) {
  const cv::Rect hidden(200, 60, 120, 54);
  test::exposed(drawn_.platform, 14)(hidden).copyTo(drawn_.lesson.after(hidden));
  const LearnResult result = learn_object(drawn_.lesson);
  ASSERT_TRUE(result.put_aside) << result.message;
  EXPECT_LT(result.put_aside->agreement, 0.75);
  EXPECT_FALSE(result.put_aside->refined);
}

INSTANTIATE_TEST_SUITE_P(Angles, PutAside, testing::Values(0, 40, 175));

// An object of the platform's colour lies on a mark of the same shape but another colour: the mark
// looks like an arrival, and the object's new place looks like the place that it left.
class LooksLikePlatform : public testing::Test {
 protected:
  LooksLikePlatform() {
    cv::Mat platform = test::texture(kSize, cv::Scalar(105, 115, 120), 16, 1, 1.2), moved;
    test::texture(kSize, cv::Scalar(90, 150, 40), 16, 2, 1.2).copyTo(platform, truth_);
    const cv::Mat object = test::texture(kSize, cv::Scalar(105, 115, 120), 18, 3, 2);
    cv::warpAffine(object, moved, cv::Matx23d(1, 0, 220, 0, 1, 0), kSize);
    cv::Mat before = platform.clone(), after = platform.clone();
    object.copyTo(before, truth_);
    moved.copyTo(after, test::wedge_map(kSize, {330, 150}));
    lesson_.name = "wedge";
    lesson_.before = test::exposed(before, 11);
    lesson_.after = test::exposed(after, 12);
  }

  void expect_learned_and_found() const {
    const LearnResult result = learn_object(lesson_);
    ASSERT_TRUE(result.put_aside) << result.message;
    EXPECT_GT(test::iou(test::map_of(result), truth_), 0.8);
    EXPECT_NEAR(result.put_aside->pose.x - result.object.views.front().reference.x, 220, 1);
  }

  const cv::Size kSize{460, 300};
  const cv::Mat truth_ = test::wedge_map(kSize, {110, 150});
  Lesson lesson_;
};

TEST_F(LooksLikePlatform, IsLearnedWhereItLay) {
  expect_learned_and_found();
}

TEST_F(LooksLikePlatform, IsFoundWithoutADetectedArrival) {
  lesson_.region = {60, 105, 100, 90};
  expect_learned_and_found();
}

// An area larger than the object changed as well, and the object lies elsewhere afterwards.
class LargerChange : public testing::Test {
 protected:
  LargerChange() {
    const cv::Matx23d matrix(1, 0, kMoved, 0, 1, 0);
    cv::Mat object, cover;
    cv::warpAffine(drawn_.scene, object, matrix, kSize);
    cv::warpAffine(drawn_.truth, cover, matrix, kSize, cv::INTER_NEAREST);
    before_ = drawn_.scene.clone();
    after_ = drawn_.platform.clone();
    object.copyTo(after_, cover);
  }

  void expect_object_learned() {
    drawn_.lesson.before = test::exposed(before_, 11);
    drawn_.lesson.after = test::exposed(after_, 12);
    drawn_.lesson.region = {};
    const LearnResult result = learn_object(drawn_.lesson);
    ASSERT_TRUE(result.put_aside) << result.message;
    EXPECT_GT(test::iou(test::map_of(result), drawn_.truth), 0.9);
    EXPECT_NEAR(result.put_aside->pose.x - result.object.views.front().reference.x, kMoved, 1);
  }

  static constexpr int kMoved = 160;  // [px]
  const cv::Size kSize{460, 300};
  test::DrawnLesson drawn_ = test::draw_lesson({80, 90}, kSize);
  cv::Mat before_, after_;
};

TEST_F(LargerChange, OfAGripperIsNotTheObject) {
  const cv::Rect gripper(330, 60, 130, 110);
  test::texture(gripper.size(), cv::Scalar(97, 107, 112), 14, 5, 2).copyTo(after_(gripper));
  expect_object_learned();
}

TEST_F(LargerChange, OfANudgedNeighbourIsNotTheObject) {
  const cv::Rect thing(60, 180, 90, 80);
  const cv::Mat looks = test::texture(thing.size(), cv::Scalar(40, 190, 60), 40, 5);
  looks.copyTo(before_(thing));
  looks.copyTo(after_(thing + cv::Point(45, 9)));
  expect_object_learned();
}

// The places are close together, the object has the platform's colours, and the noise is strong, so
// that one cut includes both places.
TEST(PutAsideLesson, SeparatesPlacesThatAreCloseTogether) {
  constexpr int kMoved = 90;  // [px]
  const cv::Size size(460, 300);
  const cv::Mat truth = test::wedge_map(size, {180, 150});
  const cv::Mat platform = test::texture(size, cv::Scalar(105, 115, 120), 16, 1, 1.2);
  const cv::Mat object = test::texture(size, cv::Scalar(115, 115, 110), 18, 3, 2);
  cv::Mat moved, before = platform.clone(), after = platform.clone();
  cv::warpAffine(object, moved, cv::Matx23d(1, 0, kMoved, 0, 1, 0), size);
  object.copyTo(before, truth);
  moved.copyTo(after, test::wedge_map(size, {180 + kMoved, 150}));
  Lesson lesson;
  lesson.name = "wedge";
  lesson.before = test::exposed(before, 11, 1, 8);
  lesson.after = test::exposed(after, 12, 1, 8);
  const LearnResult result = learn_object(lesson);
  ASSERT_TRUE(result.put_aside) << result.message;
  EXPECT_GT(test::iou(test::map_of(result), truth), 0.9);
  EXPECT_NEAR(result.put_aside->pose.x - result.object.views.front().reference.x, kMoved, 1);
}

// It is not determined which of the two is the object.
TEST(PutAsideLesson, TwoRemovedObjectsAreNotGood) {
  auto drawn = test::draw_lesson({100, 110}, kSize);
  const cv::Mat beside = test::wedge_map(kSize, {180, 110});
  test::texture(kSize, cv::Scalar(60, 90, 190), 22, 4).copyTo(drawn.scene, beside);
  drawn.lesson.before = test::exposed(drawn.scene, 11);
  for (const cv::Rect& region : {cv::Rect(), cv::Rect(40, 50, 200, 120)}) {
    drawn.lesson.region = region;
    const LearnResult result = learn_object(drawn.lesson);
    ASSERT_TRUE(result.has_model) << result.message;
    EXPECT_NE(result.object.quality.verdict, Verdict::kGood) << region;
    const auto& reasons = result.object.quality.reasons;
    EXPECT_EQ(std::count(reasons.begin(), reasons.end(), "several_left"), 1) << region;
  }
  drawn.lesson.region = {};
  InteractiveLesson edited(drawn.lesson);
  LessonEdit edit;
  edit.stroke_width = 5;
  edit.include = {{{95, 110}, {105, 110}}};
  EXPECT_NE(edited.edit(edit).object.quality.verdict, Verdict::kGood)
      << "there are two parts still";
}

TEST(PutAsideLesson, AClickSelectsOneOfTwoRemovedObjects) {
  auto drawn = test::draw_lesson(kOldPlace, kSize);
  const cv::Mat other = test::wedge_map(kSize, {250, 120});
  test::texture(kSize, cv::Scalar(60, 90, 190), 22, 4).copyTo(drawn.scene, other);
  drawn.lesson.before = test::exposed(drawn.scene, 11);
  drawn.lesson.region = {};
  const auto open_choice = [](const LearnResult& result) {
    const auto& reasons = result.object.quality.reasons;
    return std::count(reasons.begin(), reasons.end(), "several_left");
  };
  const LearnResult guessed = learn_object(drawn.lesson);
  ASSERT_TRUE(guessed.has_model) << guessed.message;
  EXPECT_EQ(guessed.object.quality.verdict, Verdict::kMarginal);
  EXPECT_EQ(open_choice(guessed), 1);
  InteractiveLesson edited(drawn.lesson);
  LessonEdit edit;
  edit.stroke_width = 5;
  edit.exclude = {{{170, 20}, {180, 20}}};
  EXPECT_EQ(open_choice(edited.edit(edit)), 1) << "a stroke on the platform tells nothing";
  const cv::Point2d learned = centroid(test::map_of(guessed));
  edit.exclude.clear();
  edit.include = {{{static_cast<float>(learned.x) - 3, static_cast<float>(learned.y)},
                   {static_cast<float>(learned.x) + 3, static_cast<float>(learned.y)}}};
  EXPECT_EQ(open_choice(edited.edit(edit)), 0) << "this object is meant";
  drawn.lesson.click = kOldPlace;
  const LearnResult clicked = learn_object(drawn.lesson);
  ASSERT_TRUE(clicked.has_model) << clicked.message;
  EXPECT_EQ(clicked.object.quality.verdict, Verdict::kGood);
  EXPECT_EQ(open_choice(clicked), 0);
  EXPECT_GT(test::iou(test::map_of(clicked), drawn.truth), 0.93);
}

TEST(PutAsideLesson, ARemovedObjectHasNoNewPlace) {
  EXPECT_FALSE(learn_object(test::draw_lesson(kOldPlace, kSize).lesson).put_aside);
}

TEST(PutAsideLesson, AnotherObjectThatArrivedIsNotTheObject) {
  auto drawn = test::draw_lesson(kOldPlace, kSize);
  cv::Mat scene = drawn.platform.clone();
  cv::circle(scene, {250, 120}, 26, cv::Scalar(190, 90, 40), cv::FILLED);
  drawn.lesson.after = test::exposed(scene, 12);
  EXPECT_FALSE(learn_object(drawn.lesson).put_aside);
}

}  // namespace
}  // namespace mbncc
