// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/learn_object.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "learning/images.hpp"
#include "mbncc/learning/interactive_lesson.hpp"

namespace mbncc {
namespace {

using test::draw_lesson;
using test::DrawnLesson;
using test::iou;

LearningConfig with_method(const std::string& method) {
  LearningConfig config;
  config.method = method;
  return config;
}

cv::Mat learned_map(const LearnResult& result) {
  return full_size_map(result.object.views.at(0));
}

class EveryMethod : public testing::TestWithParam<const char*> {};

TEST_P(EveryMethod, CutsThePlainCaseOut) {
  const DrawnLesson drawn = draw_lesson();
  const LearnResult result = learn_object(drawn.lesson, with_method(GetParam()));
  ASSERT_EQ(result.error, LearnError::kSuccess) << result.message;
  EXPECT_GT(iou(learned_map(result), drawn.truth), 0.8);
  EXPECT_NO_THROW(validate(result.object));
}

TEST_P(EveryMethod, GivesTheSameMapTwice) {
  const DrawnLesson drawn = draw_lesson();
  const LearningConfig config = with_method(GetParam());
  const cv::Mat first = learned_map(learn_object(drawn.lesson, config));
  EXPECT_EQ(cv::countNonZero(first != learned_map(learn_object(drawn.lesson, config))), 0);
}

INSTANTIATE_TEST_SUITE_P(Learning, EveryMethod,
                         testing::Values("change_cut", "sb_grabcut", "grabcut_rect",
                                         "grabcut_mask"));

TEST(LearnObject, LearnsFromARegionOnly) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after = cv::Mat();
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_EQ(result.error, LearnError::kSuccess) << result.message;
  EXPECT_GT(iou(learned_map(result), drawn.truth), 0.75);
}

TEST(LearnObject, FindsTheRegionFromTheChange) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.region = {};
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_EQ(result.error, LearnError::kSuccess) << result.message;
  EXPECT_GT(iou(learned_map(result), drawn.truth), 0.75);
}

// A shiny rail beside the object reflects it, up to the edge of the drawn region.
DrawnLesson draw_reflection() {
  DrawnLesson drawn = draw_lesson();
  const cv::Rect object(100, 70, 60, 60), reflection(72, 70, 28, 60);
  drawn.truth.setTo(0);
  drawn.truth(object).setTo(255);
  drawn.platform = test::texture(drawn.platform.size(), cv::Scalar(150, 165, 170), 3, 1);
  cv::Mat(drawn.platform, cv::Rect(60, 0, 40, 200)) -= cv::Scalar::all(40);
  drawn.scene = drawn.platform.clone();
  test::texture(drawn.scene.size(), cv::Scalar(190, 80, 40), 6, 2)(object).copyTo(
      drawn.scene(object));
  cv::Mat(drawn.scene, reflection) *= 0.55;
  cv::Mat(drawn.scene, reflection) += 0.45 * cv::Scalar(190, 80, 40);
  cv::GaussianBlur(drawn.scene, drawn.scene, {}, 0.7);
  drawn.lesson.before = test::exposed(drawn.scene, 11);
  drawn.lesson.after = test::exposed(drawn.platform, 12);
  drawn.lesson.region = cv::Rect(78, 56, 98, 90);
  return drawn;
}

TEST(LearnObject, AReflectionAtTheRegionsEdgeIsExcluded) {
  const DrawnLesson drawn = draw_reflection();
  const LearnResult by_change = learn_object(drawn.lesson, with_method("change_cut"));
  EXPECT_LT(iou(learned_map(by_change), drawn.truth), 0.85) << "shows nothing";
  const LearnResult result = learn_object(drawn.lesson);
  EXPECT_GT(iou(learned_map(result), drawn.truth), 0.95);
  ASSERT_TRUE(result.evidence);
  EXPECT_TRUE(result.evidence->verified);
  EXPECT_LT(result.evidence->stability, 0.85) << "the other cut took more";
  EXPECT_GT(result.evidence->change_beside, 0.05) << "which is a change that the map leaves out";
}

TEST(LearnObject, AStrokeKeepsTheVerifiedMapWithoutReflection) {
  const DrawnLesson drawn = draw_reflection();
  InteractiveLesson lesson(drawn.lesson);
  LessonEdit edit;
  edit.exclude = {{{90, 75}, {90, 120}}};
  edit.stroke_width = 5;
  const LearnResult edited = lesson.edit(edit);
  EXPECT_GT(iou(learned_map(edited), drawn.truth), 0.95);
  ASSERT_TRUE(edited.evidence);
  EXPECT_TRUE(edited.evidence->verified);
  EXPECT_LT(edited.evidence->stability, 0.85) << "the other cut still took more";
}

TEST(LearnObject, AStrokeOnTheReflectionSettlesWhatTheCutsDisagreeAbout) {
  const DrawnLesson drawn = draw_reflection();
  InteractiveLesson lesson(drawn.lesson);
  LessonEdit edit;
  edit.exclude = {{{88, 60}, {88, 140}}};
  edit.stroke_width = 20;
  const LearnResult edited = lesson.edit(edit);
  EXPECT_GT(iou(learned_map(edited), drawn.truth), 0.9);
  ASSERT_TRUE(edited.evidence);
  EXPECT_GT(edited.evidence->stability, 0.85);
  EXPECT_LT(edited.evidence->change_beside, 0.05);
}

// Without the image after, the two methods disagree on the reflection.
TEST(LearnObject, AStrokeInOneImageDoesNotHideThatTheMethodsDisagree) {
  DrawnLesson drawn = draw_reflection();
  drawn.lesson.after = cv::Mat();
  InteractiveLesson lesson(drawn.lesson);
  ASSERT_TRUE(lesson.result().evidence);
  const double first = lesson.result().evidence->stability;
  EXPECT_LT(first, 0.85) << "shows nothing";
  LessonEdit edit;
  edit.stroke_width = 5;
  edit.include = {{{130, 90}, {130, 110}}};
  EXPECT_LT(lesson.edit(edit).evidence->stability, 0.85) << "the stroke does not touch the dispute";
  edit.include.clear();
  edit.exclude = {{{90, 75}, {90, 120}}};
  EXPECT_GT(lesson.edit(edit).evidence->stability, first) << "the stroke settles a part of it";
}

// The region cut does not find a faint object, GrabCut finds something.
TEST(LearnObject, AStrokeInOneImageDoesNotHideThatOnlyOneMethodFindsAnything) {
  DrawnLesson drawn = draw_lesson();
  cv::Mat scene = test::texture(drawn.truth.size(), cv::Scalar(105, 115, 120), 4, 1);
  cv::add(scene, cv::Scalar::all(10), scene, drawn.truth);
  drawn.lesson.before = test::exposed(scene, 11);
  drawn.lesson.after = cv::Mat();
  InteractiveLesson lesson(drawn.lesson);
  ASSERT_TRUE(lesson.result().evidence);
  EXPECT_EQ(lesson.result().evidence->stability, 0);
  LessonEdit edit;
  edit.stroke_width = 5;
  edit.include = {{{115, 100}, {125, 100}}};
  const LearnResult edited = lesson.edit(edit);
  EXPECT_LT(edited.evidence->stability, 0.5);
  EXPECT_EQ(edited.object.quality.verdict, Verdict::kBad);
}

// The survey finds only the wedge, but the cut finds the whole object.
TEST(LearnObject, WidensARegionThatWasNotDrawn) {
  DrawnLesson drawn = draw_lesson();
  const cv::Rect faint(150, 84, 60, 16);
  drawn.scene(faint) = cv::Scalar(110, 110, 115);
  drawn.truth(faint).setTo(255);
  drawn.platform = test::texture(drawn.platform.size(), cv::Scalar(105, 115, 120), 2, 1);
  test::texture(drawn.platform.size(), cv::Scalar(90, 105, 135), 5, 2)
      .copyTo(drawn.scene, test::wedge_map(drawn.platform.size(), {120, 100}));
  drawn.platform.copyTo(drawn.scene, ~drawn.truth);
  drawn.lesson.before = test::exposed(drawn.scene, 11, 1, 1);
  drawn.lesson.after = test::exposed(drawn.platform, 12, 1, 1);
  drawn.lesson.region = {};
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_TRUE(result.has_model);
  EXPECT_GT(iou(learned_map(result), drawn.truth), 0.8);
  for (const auto& reason : result.object.quality.reasons) EXPECT_NE(reason, "touches_region_edge");
}

const cv::Rect kTile(90, 70, 80, 48);

// A tile among others; the edges of its dots are as strong as its outline.
DrawnLesson draw_tile(const cv::Rect& region) {
  const cv::Scalar bright(215, 225, 230), dark(30, 30, 35);
  const int gap = 7;
  DrawnLesson drawn = draw_lesson();
  drawn.truth.setTo(0);
  drawn.truth(kTile).setTo(255);
  drawn.platform = test::texture(drawn.platform.size(), cv::Scalar(60, 110, 70), 4, 1);
  for (const int x : {-1, 0, 1})
    for (const int y : {-1, 0, 1})
      if (x != 0 || y != 0)
        cv::rectangle(drawn.platform,
                      kTile + cv::Point(x * (kTile.width + gap), y * (kTile.height + gap)), bright,
                      cv::FILLED);
  drawn.scene = drawn.platform.clone();
  drawn.scene(kTile) = bright;
  for (const int x : {106, 154}) cv::circle(drawn.scene, {x, 94}, 8, dark, cv::FILLED);
  cv::GaussianBlur(drawn.scene, drawn.scene, {}, 0.7);
  drawn.lesson.before = test::exposed(drawn.scene, 11);
  drawn.lesson.after = test::exposed(drawn.platform, 12);
  drawn.lesson.region = region;
  return drawn;
}

cv::Rect smaller(const cv::Rect& rect, int margin) {
  return {rect.x + margin, rect.y + margin, rect.width - 2 * margin, rect.height - 2 * margin};
}

TEST(LearnObject, ADrawnRegionMayBeTightOrSlightlyTooSmall) {
  for (const int margin : {0, 3}) {
    const DrawnLesson drawn = draw_tile(smaller(kTile, margin));
    const LearnResult result = learn_object(drawn.lesson);
    ASSERT_TRUE(result.has_model) << result.message;
    EXPECT_GT(iou(learned_map(result), drawn.truth), 0.95) << margin;
    EXPECT_EQ(result.object.quality.verdict, Verdict::kGood) << margin;
  }
}

// A region whose left edge lies `inside` [px] the tile, with platform on the other sides.
DrawnLesson tile_cut_off_by(int inside) {
  const cv::Point margin(6, 6);
  cv::Rect region(kTile.tl() - margin, kTile.br() + margin);
  region.x += margin.x + inside;
  region.width -= margin.x + inside;
  return draw_tile(region);
}

TEST(LearnObject, ADrawnRegionMayCutOffLittleOnOneSide) {
  const DrawnLesson drawn = tile_cut_off_by(3);
  const LearnResult result = learn_object(drawn.lesson);
  EXPECT_GT(iou(learned_map(result), drawn.truth), 0.97);
  EXPECT_EQ(result.object.quality.verdict, Verdict::kGood);
}

TEST(LearnObject, ADrawnRegionThatCutsOffMoreIsReported) {
  for (const int inside : {10, 14, 25}) {
    const DrawnLesson drawn = tile_cut_off_by(inside);
    const auto& quality = learn_object(drawn.lesson).object.quality;
    EXPECT_EQ(std::count(quality.reasons.begin(), quality.reasons.end(), "touches_region_edge"), 1)
        << inside;
    EXPECT_NE(quality.verdict, Verdict::kGood) << inside;
  }
}

// A wider region would add a strip of the reflection to the map.
TEST(LearnObject, ADrawnRegionDoesNotGrowIntoMoreOfAReflection) {
  DrawnLesson drawn = draw_reflection();
  drawn.lesson.region = cv::Rect(90, 50, 140, 100);
  const LearnResult result = learn_object(drawn.lesson, with_method("change_cut"));
  const auto& reasons = result.object.quality.reasons;
  EXPECT_EQ(std::count(reasons.begin(), reasons.end(), "touches_region_edge"), 1);
  EXPECT_EQ(cv::countNonZero(learned_map(result).colRange(0, 90)), 0);
}

TEST(LearnObject, ATightRegionInOneImageGivesTheWholeObject) {
  DrawnLesson drawn = draw_tile(kTile);
  drawn.lesson.after = cv::Mat();
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_TRUE(result.has_model) << result.message;
  EXPECT_GT(iou(learned_map(result), drawn.truth), 0.9);
}

// A grown region would be the whole image, which leaves no background.
TEST(LearnObject, ATightRegionThatCannotGrowIsKept) {
  DrawnLesson drawn = draw_lesson();
  const cv::Rect board(10, 10, 220, 180);
  const std::vector<cv::Point> octagon = {{50, 10},   {189, 10}, {229, 50}, {229, 149},
                                          {189, 189}, {50, 189}, {10, 149}, {10, 50}};
  cv::fillConvexPoly(drawn.scene, octagon, cv::Scalar(215, 225, 230));
  drawn.lesson.before = test::exposed(drawn.scene, 11);
  drawn.lesson.after = cv::Mat();
  drawn.lesson.region = board;
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_TRUE(result.has_model) << result.message;
  EXPECT_EQ(cv::boundingRect(learned_map(result)), board);
}

TEST(LearnObject, ARegionThatCutsTheObjectOffIsNotGood) {
  const DrawnLesson drawn = draw_tile({kTile.x - 10, kTile.y - 10, kTile.width + 20, 24});
  const LearnResult result = learn_object(drawn.lesson);
  EXPECT_LT(iou(learned_map(result), drawn.truth), 0.6) << "the region hardly grows";
  EXPECT_NE(result.object.quality.verdict, Verdict::kGood);
}

TEST(LearnObject, UsesAGivenMapUnchanged) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.map = drawn.truth;
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_EQ(result.error, LearnError::kSuccess);
  EXPECT_EQ(cv::countNonZero(learned_map(result) != drawn.truth), 0);
}

TEST(LearnObject, NeverRefusesAGivenMapForQuality) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.map = cv::Mat::zeros(drawn.truth.size(), CV_8UC1);
  drawn.lesson.map(cv::Rect(0, 0, 6, 6)).setTo(255);
  const LearnResult result = learn_object(drawn.lesson);
  EXPECT_EQ(result.error, LearnError::kSuccess);
  EXPECT_EQ(result.object.quality.verdict, Verdict::kMarginal);
  EXPECT_FALSE(result.object.quality.reasons.empty());
}

TEST(LearnObject, UsesADrawnOutlineUnchanged) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after = cv::Mat();
  drawn.lesson.outline = {{80, 70}, {160, 70}, {160, 130}, {80, 130}};
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_EQ(result.error, LearnError::kSuccess) << result.message;
  const cv::Rect box = cv::boundingRect(learned_map(result));
  EXPECT_EQ(box, cv::Rect(80, 70, 81, 61));
}

TEST(LearnObject, RefinesAnOutlineWhenAskedTo) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after = cv::Mat();
  drawn.lesson.outline = {{80, 66}, {164, 66}, {164, 138}, {80, 138}};
  const LearnResult result = learn_object(drawn.lesson, with_method("grabcut_mask"));
  ASSERT_EQ(result.error, LearnError::kSuccess) << result.message;
  EXPECT_GT(iou(learned_map(result), drawn.truth), 0.75);
}

TEST(LearnObject, PutsTheReferenceAtTheCentroidByDefault) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.map = drawn.truth;
  const cv::Point2d centre = centroid(drawn.truth);
  Pose2D reference = learn_object(drawn.lesson).object.views.at(0).reference;
  EXPECT_DOUBLE_EQ(reference.x, centre.x);
  EXPECT_DOUBLE_EQ(reference.y, centre.y);
  drawn.lesson.reference = Pose2D{30, 40, 0.5};
  reference = learn_object(drawn.lesson).object.views.at(0).reference;
  EXPECT_DOUBLE_EQ(reference.x, 30);
  EXPECT_DOUBLE_EQ(reference.theta, 0.5);
}

TEST(LearnObject, StoresNameLabelTimeAndTimings) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.label = "Keil";
  drawn.lesson.symmetry = 3;
  const LearnResult result = learn_object(drawn.lesson);
  EXPECT_EQ(result.object.name, "wedge");
  EXPECT_EQ(result.object.label, "Keil");
  EXPECT_EQ(result.object.symmetry, 3);
  EXPECT_EQ(result.object.quality.symmetry, 3);
  EXPECT_GT(result.object.learned_at, 0);
  for (const char* step : {"region", "segment", "quality", "total"})
    EXPECT_TRUE(result.timings_ms.count(step)) << step;
}

}  // namespace
}  // namespace mbncc
