// SPDX-License-Identifier: BSD-3-Clause
// The operator shows the object by a click on it.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "learning/images.hpp"
#include "mbncc/learning/interactive_lesson.hpp"
#include "mbncc/learning/learn_object.hpp"

namespace mbncc {
namespace {

using test::draw_lesson;
using test::iou;
using test::map_of;

TEST(Click, PicksTheChangeUnderIt) {
  auto drawn = draw_lesson({70, 100}, {320, 200});
  const cv::Mat other = test::wedge_map({320, 200}, {240, 100});
  test::texture({320, 200}, cv::Scalar(160, 90, 60), 22, 3).copyTo(drawn.scene, other);
  drawn.lesson.before = test::exposed(drawn.scene, 11);
  drawn.lesson.region = {};
  drawn.lesson.click = cv::Point2d(70, 100);
  EXPECT_GT(iou(map_of(learn_object(drawn.lesson)), drawn.truth), 0.9);
  drawn.lesson.click = cv::Point2d(240, 100);
  EXPECT_GT(iou(map_of(learn_object(drawn.lesson)), other), 0.9);
}

// A dark ring whose inside has the platform's colour.
struct Ring {
  /// `light`: of the inside, relative to the platform; below 1, both are plain.
  explicit Ring(double light = 1, int hole_radius = 30) {
    const cv::Size size(400, 200);
    auto drawn = draw_lesson(kCentre, size);
    platform = drawn.platform;
    if (light < 1) platform.setTo(cv::mean(platform));
    cv::Mat scene = platform.clone();
    disc = cv::Mat::zeros(size, CV_8UC1);
    cv::Mat inside = disc.clone();
    cv::circle(disc, kCentre, 45, cv::Scalar(255), cv::FILLED);
    cv::circle(inside, kCentre, hole_radius, cv::Scalar(255), cv::FILLED);
    ring = disc & ~inside;
    if (light < 1) scene.setTo(light * cv::mean(platform), inside);
    scene.setTo(cv::Scalar(30, 30, 30), ring);
    lesson = drawn.lesson;
    lesson.before = test::exposed(scene, 11);
    lesson.after = test::exposed(platform, 12);
    lesson.region = {};
    lesson.click = kCentre;
  }

  // The ring lies beside its place afterwards.
  void put_aside() {
    cv::Mat after = platform.clone(), moved;
    cv::warpAffine(ring, moved, cv::Matx23d(1, 0, 140, 0, 1, 0), ring.size(), cv::INTER_NEAREST);
    after.setTo(cv::Scalar(30, 30, 30), moved);
    lesson.after = test::exposed(after, 12);
  }

  static inline const cv::Point kCentre{160, 100};
  Lesson lesson;
  cv::Mat platform, disc, ring;
};

TEST(Click, FillsTheHoleAroundIt) {
  Ring drawn;
  EXPECT_GT(iou(map_of(learn_object(drawn.lesson)), drawn.disc), 0.9);
  drawn.lesson.click = cv::Point2d(197, 100);
  EXPECT_GT(iou(map_of(learn_object(drawn.lesson)), drawn.ring), 0.9) << "on the ring";
  drawn.lesson.click = cv::Point2d(182, 100);
  EXPECT_GT(iou(map_of(learn_object(drawn.lesson)), drawn.ring), 0.9) << "missed it by little";
}

// The same object as a region teaches it: the operator is asked about the inside.
TEST(Click, ARegionAroundADarkHoleAsksForAClick) {
  Ring drawn(0.95);
  drawn.lesson.region = cv::boundingRect(drawn.disc) + cv::Size(30, 30) - cv::Point(15, 15);
  drawn.lesson.click.reset();
  const auto asks = [](const LearnResult& result) {
    const auto& reasons = result.object.quality.reasons;
    return std::count(reasons.begin(), reasons.end(), "unconfirmed_hole") == 1;
  };
  const LearnResult open = learn_object(drawn.lesson);
  EXPECT_GT(iou(map_of(open), drawn.ring), 0.9);
  EXPECT_TRUE(asks(open));
  EXPECT_EQ(open.object.quality.verdict, Verdict::kBad) << "the hole is .44 of the disc";
  drawn.lesson.click = Ring::kCentre;
  const LearnResult filled = learn_object(drawn.lesson);
  EXPECT_GT(iou(map_of(filled), drawn.disc), 0.9);
  EXPECT_FALSE(asks(filled));
}

TEST(Click, AStrokeOpensAFilledHole) {
  const Ring drawn;
  InteractiveLesson edited(drawn.lesson);
  LessonEdit edit;
  edit.stroke_width = 5;
  edit.include = {{{190, 100}, {198, 100}}};
  EXPECT_GT(iou(map_of(edited.edit(edit)), drawn.disc), 0.9) << "still filled";
  edit.include.clear();
  edit.exclude = {{{150, 100}, {170, 100}}};
  EXPECT_GT(iou(map_of(edited.edit(edit)), drawn.ring), 0.9);
}

TEST(Click, AStrokeKeepsTheHoleFilledIfTheObjectWasPutAside) {
  Ring drawn(1, 20);
  drawn.put_aside();
  InteractiveLesson edited(drawn.lesson);
  ASSERT_TRUE(edited.result().put_aside);
  EXPECT_TRUE(edited.result().put_aside->refined);
  EXPECT_GT(iou(map_of(edited.result()), drawn.disc), 0.9);
  LessonEdit edit;
  edit.stroke_width = 5;
  edit.include = {{{190, 100}, {198, 100}}};
  EXPECT_GT(iou(map_of(edited.edit(edit)), drawn.disc), 0.9);
  edit.include.clear();
  edit.exclude = {{{155, 100}, {165, 100}}};
  EXPECT_GT(iou(map_of(edited.edit(edit)), drawn.ring), 0.9) << "a stroke opens it";
}

// Two neighbours that nearly touch were taken away together; the click selects one of them.
TEST(Click, SelectsOneOfTwoRemovedNeighbours) {
  const cv::Size size(320, 200);
  auto drawn = draw_lesson({110, 100}, size);
  const cv::Mat other = test::wedge_map(size, {186, 100}) & ~drawn.truth;
  test::texture(size, cv::Scalar(60, 90, 190), 22, 2).copyTo(drawn.scene, other);
  drawn.lesson.before = test::exposed(drawn.scene, 11);
  drawn.lesson.region = {};
  drawn.lesson.click = cv::Point2d(110, 100);
  EXPECT_GT(iou(map_of(learn_object(drawn.lesson)), drawn.truth), 0.9);
}

// A nut in the corner of a bracket left as well. A stroke must not bring it back.
TEST(Click, AStrokeDoesNotAddAnExcludedNeighbour) {
  const cv::Size size(340, 240);
  const auto drawn = draw_lesson({80, 110}, size);
  cv::Mat bracket = cv::Mat::zeros(size, CV_8UC1), nut = bracket.clone();
  cv::rectangle(bracket, {120, 60}, {150, 180}, cv::Scalar(255), cv::FILLED);
  cv::rectangle(bracket, {120, 145}, {240, 180}, cv::Scalar(255), cv::FILLED);
  cv::circle(nut, {200, 100}, 30, cv::Scalar(255), cv::FILLED);
  cv::Mat scene = drawn.platform.clone();
  test::texture(size, cv::Scalar(40, 60, 190), 22, 2).copyTo(scene, bracket);
  test::texture(size, cv::Scalar(190, 80, 40), 22, 3).copyTo(scene, nut);
  Lesson lesson = drawn.lesson;
  lesson.before = test::exposed(scene, 11);
  lesson.after = test::exposed(drawn.platform, 12);
  lesson.region = {};
  lesson.click = cv::Point2d(135, 120);
  InteractiveLesson edited(lesson);
  EXPECT_GT(iou(map_of(edited.result()), bracket), 0.9);
  LessonEdit edit;
  edit.stroke_width = 3;
  edit.include = {{{135, 100}, {135, 110}}};
  EXPECT_GT(iou(map_of(edited.edit(edit)), bracket), 0.9);
  edit.include = {{{195, 100}, {205, 100}}};
  EXPECT_GT(iou(map_of(edited.edit(edit)), bracket | nut), 0.9) << "unless the stroke means it";
}

// The cloth under the object moved as well, except at the image's border.
TEST(Click, WorksOnAPlatformThatAlsoChanged) {
  const cv::Size size(320, 240);
  const auto drawn = draw_lesson({160, 120}, size);
  cv::Mat moving = cv::Mat::zeros(size, CV_32FC3);
  cv::rectangle(moving, cv::Rect(60, 50, 200, 140), cv::Scalar::all(1), cv::FILLED);
  cv::GaussianBlur(moving, moving, {}, 12);
  const auto cloth = [&](int seed) {
    const cv::Mat moved = test::texture(size, cv::Scalar(105, 115, 120), 20, seed, 2);
    return cv::Mat(drawn.platform + moving.mul(moved - drawn.platform));
  };
  Lesson lesson = drawn.lesson;
  cv::Mat scene = cloth(5);
  drawn.scene.copyTo(scene, drawn.truth);
  lesson.before = test::exposed(scene, 11);
  lesson.after = test::exposed(cloth(6), 12);
  lesson.region = {};
  lesson.click = cv::Point2d(155, 120);
  const LearnResult result = learn_object(lesson);
  ASSERT_TRUE(result.has_model) << result.message;
  EXPECT_GT(iou(map_of(result), drawn.truth), 0.8);
}

TEST(Click, FarFromAllChangeIsRefused) {
  auto drawn = draw_lesson();
  drawn.lesson.region = {};
  drawn.lesson.click = cv::Point2d(220, 20);
  EXPECT_EQ(learn_object(drawn.lesson).error, LearnError::kNoChange);
}

TEST(Click, FindsAClearlyVisibleObjectInOneImage) {
  auto drawn = draw_lesson();
  drawn.lesson.after = cv::Mat();
  drawn.lesson.region = {};
  drawn.lesson.click = cv::Point2d(115, 100);
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_TRUE(result.has_model);
  EXPECT_GT(iou(map_of(result), drawn.truth), 0.8);
  EXPECT_NE(result.object.quality.verdict, Verdict::kGood);
}

// A click does not tell whether the disc or the plate below it is meant.
Lesson disc_on_plate() {
  Lesson lesson;
  lesson.name = "object";
  cv::Mat scene = test::texture({320, 240}, cv::Scalar(105, 115, 120), 4, 1);
  cv::circle(scene, {160, 120}, 52, cv::Scalar(60, 90, 190), cv::FILLED);
  cv::circle(scene, {160, 120}, 20, cv::Scalar(190, 160, 60), cv::FILLED);
  lesson.before = test::exposed(scene, 11);
  lesson.click = cv::Point2d(160, 120);
  return lesson;
}

TEST(Click, AnAmbiguousClickInOneImageGivesAnUnstableMap) {
  const LearnResult result = learn_object(disc_on_plate());
  ASSERT_TRUE(result.evidence);
  EXPECT_GT(result.evidence->boundary_contrast, 0.8) << "either has a clear edge";
  EXPECT_LT(result.evidence->stability, 0.9);
}

TEST(Click, AStrokeDoesNotMakeAnAmbiguousMapStable) {
  InteractiveLesson lesson(disc_on_plate());
  const double stability = lesson.result().evidence->stability;
  LessonEdit edit;
  edit.stroke_width = 5;
  edit.include = {{{155, 120}, {165, 120}}};
  const LearnResult edited = lesson.edit(edit);
  ASSERT_TRUE(edited.evidence);
  EXPECT_LE(edited.evidence->stability, stability);
}

TEST(Click, OutsideTheRegionIsRefused) {
  auto drawn = draw_lesson({160, 120}, {320, 240});
  for (const cv::Mat& after : {drawn.lesson.after, cv::Mat()}) {
    Lesson lesson = drawn.lesson;
    lesson.after = after;
    lesson.click = cv::Point2d(10, 230);
    EXPECT_NE(learn_object(lesson).error, LearnError::kSuccess);
  }
}

TEST(Click, InOneImageTheRegionLimitsTheSize) {
  auto drawn = draw_lesson({160, 120}, {320, 240});
  drawn.lesson.after = cv::Mat();
  drawn.lesson.click = cv::Point2d(155, 120);
  EXPECT_GT(iou(map_of(learn_object(drawn.lesson)), drawn.truth), 0.8);
}

TEST(Click, OutsideTheImageIsRefused) {
  auto drawn = draw_lesson();
  drawn.lesson.click = cv::Point2d(-1, 20);
  EXPECT_EQ(learn_object(drawn.lesson).error, LearnError::kRegionInvalid);
  drawn.lesson.click = cv::Point2d(std::numeric_limits<double>::quiet_NaN(), 20);
  EXPECT_EQ(learn_object(drawn.lesson).error, LearnError::kRegionInvalid);
}

}  // namespace
}  // namespace mbncc
