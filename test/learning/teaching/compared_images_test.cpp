// SPDX-License-Identifier: BSD-3-Clause
// Which pairs of images a lesson compares, and which it refuses.
#include "mbncc/learning/learn_object.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "learning/images.hpp"

namespace mbncc {
namespace {

using test::draw_lesson;
using test::DrawnLesson;

using test::error_for;

TEST(ComparedImages, WithoutAChangeAreRefused) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after = test::exposed(drawn.scene, 77);
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kNoChange);
  drawn.lesson.region = {};
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kNoChange);
}

TEST(ComparedImages, OfAnotherSceneAreRefused) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after =
      test::exposed(test::texture(drawn.truth.size(), cv::Scalar(105, 115, 120), 14, 99), 12);
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kChangeTooLarge);
}

/// A lesson whose image after shows the same platform in different light.
class LightChanged : public testing::Test {
 protected:
  void refused_without_a_place_and_learned_with_one(const cv::Mat& radiance) {
    Lesson lesson = drawn_.lesson;
    lesson.after = test::exposed(radiance, 12);
    lesson.region = {};
    EXPECT_EQ(error_for(lesson), LearnError::kChangeTooLarge);
    lesson.region = cv::Rect(0, 0, 320, 200);
    EXPECT_EQ(error_for(lesson), LearnError::kChangeTooLarge) << "no place, more than half";
    expect_right_map(lesson, drawn_.lesson.region, {});
    expect_right_map(lesson, {}, cv::Point2d(160, 120));
  }

  const DrawnLesson drawn_ = draw_lesson({160, 120}, {320, 240});

 private:
  void expect_right_map(Lesson lesson, const cv::Rect& region,
                        const std::optional<cv::Point2d>& click) {
    lesson.region = region;
    lesson.click = click;
    const LearnResult result = learn_object(lesson);
    ASSERT_TRUE(result.has_model) << result.message;
    EXPECT_GT(test::iou(full_size_map(result.object.views.at(0)), drawn_.truth), 0.85);
  }
};

TEST_F(LightChanged, SwitchedLightNeedsAPlace) {
  for (const double gain : {0.5, 1.7})
    refused_without_a_place_and_learned_with_one(drawn_.platform * gain);
}

// Dark images with a black level of several grey levels, which looks like a much lower exposure.
TEST(ComparedImages, ABlackLevelIsNoLightChange) {
  DrawnLesson drawn = draw_lesson({160, 120}, {320, 240});
  const auto dark = [](const cv::Mat& radiance, double gain, double offset) {
    return cv::Mat(radiance * (0.4 * gain) + cv::Scalar::all(offset));
  };
  drawn.lesson.before = test::exposed(dark(drawn.scene, 1, 0), 11);
  drawn.lesson.after = test::exposed(dark(drawn.platform, 0.8, -6), 12);
  const Lesson& lesson = drawn.lesson;
  EXPECT_GT(cv::mean(lesson.before)[0], 1.41 * cv::mean(lesson.after)[0]) << "as if switched";
  EXPECT_NO_THROW(learn_object(lesson));
  drawn.lesson.after = test::exposed(dark(drawn.platform, 0.6, 0), 12);
  drawn.lesson.region = {};
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kChangeTooLarge);
}

TEST_F(LightChanged, LightFromAnotherSideNeedsAPlace) {
  cv::Mat platform = drawn_.platform.clone();
  for (int x = 0; x < platform.cols; ++x) platform.col(x) *= 0.75 + 0.5 * x / platform.cols;
  refused_without_a_place_and_learned_with_one(platform);
}

/// A platform that is larger than the image, so that a moved camera shows other parts of it.
cv::Mat wide_platform() {
  return test::texture({420, 340}, cv::Scalar(105, 115, 120), 14, 1);
}

/// The object on the part of `wide` that the camera shows before it moves.
DrawnLesson lesson_on(const cv::Mat& wide) {
  DrawnLesson drawn = draw_lesson({160, 120}, {320, 240});
  cv::Mat scene = wide(cv::Rect(40, 40, 320, 240)).clone();
  drawn.scene.copyTo(scene, drawn.truth);
  drawn.lesson.before = test::exposed(scene, 11);
  return drawn;
}

TEST(ComparedImages, OfAPushedCameraAreRefused) {
  const cv::Mat wide = wide_platform();
  DrawnLesson drawn = lesson_on(wide);
  drawn.lesson.after = test::exposed(wide(cv::Rect(65, 30, 320, 240)), 12);
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kChangeTooLarge);
  cv::Mat turned;
  cv::warpAffine(wide, turned, cv::getRotationMatrix2D({200, 160}, 4, 1), wide.size());
  drawn.lesson.after = test::exposed(turned(cv::Rect(40, 40, 320, 240)), 12);
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kChangeTooLarge);
}

TEST(ComparedImages, MayDifferInExposureAndByASmallShift) {
  const cv::Mat wide = wide_platform();
  DrawnLesson drawn = lesson_on(wide);
  drawn.lesson.after = test::exposed(wide(cv::Rect(43, 38, 320, 240)), 12, 1.15);
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_EQ(result.error, LearnError::kSuccess) << result.message;
  EXPECT_GT(test::iou(full_size_map(result.object.views.at(0)), drawn.truth), 0.85);
}

// Neighbours that were also taken away change most of the image.
TEST(ComparedImages, SurroundingsMayChangeIfThePlaceIsGiven) {
  const cv::Size size(320, 240);
  DrawnLesson drawn = draw_lesson({160, 120}, size);
  cv::Mat scene = drawn.scene.clone();
  const cv::Mat other = test::texture(size, cv::Scalar(60, 160, 60), 20, 7);
  for (const cv::Rect& tray : {cv::Rect(0, 0, 80, 240), cv::Rect(240, 0, 80, 240)})
    other(tray).copyTo(scene(tray));
  Lesson lesson = drawn.lesson;
  lesson.before = test::exposed(scene, 11);
  const LearnResult result = learn_object(lesson);
  ASSERT_TRUE(result.has_model) << result.message;
  EXPECT_GT(test::iou(full_size_map(result.object.views.at(0)), drawn.truth), 0.85);
  lesson.region = {};
  EXPECT_EQ(error_for(lesson), LearnError::kChangeTooLarge);
}

// Most of the texture is removed, but the rest does not move.
TEST(ComparedImages, MayShowAClearedTable) {
  const cv::Size size(320, 240);
  DrawnLesson drawn = draw_lesson({60, 60}, size);
  cv::Mat table = test::texture(size, cv::Scalar(105, 115, 120), 1, 1);
  const cv::Mat edge(table, cv::Rect(0, 200, 320, 40));
  test::texture(edge.size(), cv::Scalar(90, 90, 90), 14, 5).copyTo(edge);
  cv::Mat scene = table.clone();
  for (const cv::Point& at : {cv::Point(60, 60), {160, 50}, {260, 60}, {160, 140}, {260, 140}})
    test::texture(size, cv::Scalar(60, 90, 190), 22, 2).copyTo(scene, test::wedge_map(size, at));
  drawn.lesson.before = test::exposed(scene, 11);
  drawn.lesson.after = test::exposed(table, 12);
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_EQ(result.error, LearnError::kSuccess) << result.message;
  EXPECT_GT(test::iou(full_size_map(result.object.views.at(0)), drawn.truth), 0.9);
}

}  // namespace
}  // namespace mbncc
