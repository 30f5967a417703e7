#include "mbncc/learning/learn_object.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "learning/pictures.hpp"

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

TEST(LearnObject, LearnsFromARegionAlone) {
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

TEST(LearnObject, TakesAReadyMapAsItIs) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.map = drawn.truth;
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_EQ(result.error, LearnError::kSuccess);
  EXPECT_EQ(cv::countNonZero(learned_map(result) != drawn.truth), 0);
}

TEST(LearnObject, NeverRefusesAReadyMapForQuality) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.map = cv::Mat::zeros(drawn.truth.size(), CV_8UC1);
  drawn.lesson.map(cv::Rect(0, 0, 6, 6)).setTo(255);
  const LearnResult result = learn_object(drawn.lesson);
  EXPECT_EQ(result.error, LearnError::kSuccess);
  EXPECT_EQ(result.object.quality.verdict, Verdict::kMarginal);
  EXPECT_FALSE(result.object.quality.reasons.empty());
}

TEST(LearnObject, TakesAnOutlineAsDrawn) {
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

TEST(LearnObject, PutsTheReferenceAtTheCentroidUnlessToldOtherwise) {
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

TEST(LearnObject, NotesNameLabelTimeAndTimings) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.label = "Keil";
  const LearnResult result = learn_object(drawn.lesson);
  EXPECT_EQ(result.object.name, "wedge");
  EXPECT_EQ(result.object.label, "Keil");
  EXPECT_GT(result.object.learned_at, 0);
  for (const char* step : {"region", "segment", "quality", "total"})
    EXPECT_TRUE(result.timings_ms.count(step)) << step;
}

// Observer

TEST(LearnObject, ReportsStagesInOrderWithRisingProgress) {
  const DrawnLesson drawn = draw_lesson();
  Stage last_stage = Stage::kRegion;
  double last_progress = 0;
  int pictures = 0;
  learn_object(drawn.lesson, {}, {},
               [&](Stage stage, double progress, const std::string& message, const cv::Mat& step) {
                 EXPECT_GE(stage, last_stage);
                 EXPECT_GE(progress, last_progress);
                 EXPECT_FALSE(message.empty());
                 if (!step.empty()) {
                   EXPECT_EQ(step.type(), CV_8UC3);
                   ++pictures;
                 }
                 last_stage = stage;
                 last_progress = progress;
                 return true;
               });
  EXPECT_EQ(last_stage, Stage::kQuality);
  EXPECT_EQ(last_progress, 1);
  EXPECT_GE(pictures, 3);
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

// Errors

LearnError error_for(const Lesson& lesson) {
  const LearnResult result = learn_object(lesson);
  EXPECT_FALSE(result.message.empty());
  EXPECT_FALSE(result.hint.empty());
  return result.error;
}

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

TEST(LearnErrors, ChangeCutNeedsAPictureAfter) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after = cv::Mat();
  EXPECT_EQ(learn_object(drawn.lesson, with_method("change_cut")).error, LearnError::kNoImage);
}

TEST(LearnErrors, NothingSaysWhereTheObjectIs) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after = cv::Mat();
  drawn.lesson.region = {};
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kRegionInvalid);
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
                                                       {{10, 10}, {1e9F, 10}, {20, 60}}};
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

TEST(LearnErrors, NoChange) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after = test::exposed(drawn.scene, 77);
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kNoChange);
  drawn.lesson.region = {};
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kNoChange);
}

TEST(LearnErrors, ChangeTooLarge) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after =
      test::exposed(test::texture(drawn.truth.size(), cv::Scalar(105, 115, 120), 14, 99), 12);
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kChangeTooLarge);
}

// What the survey refuses: the same scene under another light, or seen by a moved camera.
LearnError error_for_after(const cv::Mat& radiance) {
  DrawnLesson drawn = draw_lesson({160, 120}, {320, 240});
  drawn.lesson.after = test::exposed(radiance, 12);
  return error_for(drawn.lesson);
}

TEST(LearnErrors, LightSwitched) {
  const cv::Mat platform = draw_lesson({160, 120}, {320, 240}).platform;
  for (const double gain : {0.5, 1.7})
    EXPECT_EQ(error_for_after(platform * gain), LearnError::kChangeTooLarge) << gain;
}

TEST(LearnErrors, LightFromElsewhere) {
  cv::Mat platform = draw_lesson({160, 120}, {320, 240}).platform;
  for (int x = 0; x < platform.cols; ++x) platform.col(x) *= 0.75 + 0.5 * x / platform.cols;
  EXPECT_EQ(error_for_after(platform), LearnError::kChangeTooLarge);
}

TEST(LearnErrors, CameraPushed) {
  const cv::Mat wide = test::texture({420, 340}, cv::Scalar(105, 115, 120), 14, 1);
  DrawnLesson drawn = draw_lesson({160, 120}, {320, 240});
  cv::Mat scene = wide(cv::Rect(40, 40, 320, 240)).clone();
  drawn.scene.copyTo(scene, drawn.truth);
  drawn.lesson.before = test::exposed(scene, 11);
  drawn.lesson.after = test::exposed(wide(cv::Rect(65, 30, 320, 240)), 12);
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kChangeTooLarge);
  cv::Mat turned;
  cv::warpAffine(wide, turned, cv::getRotationMatrix2D({200, 160}, 4, 1), wide.size());
  drawn.lesson.after = test::exposed(turned(cv::Rect(40, 40, 320, 240)), 12);
  EXPECT_EQ(error_for(drawn.lesson), LearnError::kChangeTooLarge);
}

TEST(LearnObject, ForgivesExposureAndASmallShift) {
  const cv::Mat wide = test::texture({420, 340}, cv::Scalar(105, 115, 120), 14, 1);
  DrawnLesson drawn = draw_lesson({160, 120}, {320, 240});
  cv::Mat scene = wide(cv::Rect(40, 40, 320, 240)).clone();
  drawn.scene.copyTo(scene, drawn.truth);
  drawn.lesson.before = test::exposed(scene, 11);
  drawn.lesson.after = test::exposed(wide(cv::Rect(43, 38, 320, 240)), 12, 1.15);
  const LearnResult result = learn_object(drawn.lesson);
  ASSERT_EQ(result.error, LearnError::kSuccess) << result.message;
  EXPECT_GT(iou(learned_map(result), drawn.truth), 0.85);
}

TEST(LearnErrors, TouchesBorder) {
  const DrawnLesson drawn = draw_lesson({30, 100});
  const LearnResult result = learn_object(drawn.lesson);
  EXPECT_EQ(result.error, LearnError::kTouchesBorder);
  EXPECT_TRUE(result.has_model) << "the caller may store it all the same";
  EXPECT_EQ(result.object.quality.verdict, Verdict::kBad);
  EXPECT_EQ(result.object.quality.reasons.front(), "touches_image_border");
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
}

}  // namespace
}  // namespace mbncc
