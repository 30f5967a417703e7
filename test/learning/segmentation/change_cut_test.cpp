// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/change_cut.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"
#include "mbncc/learning/change.hpp"

namespace mbncc {
namespace {

using test::draw_lesson;
using test::DrawnLesson;

ObjectCut cut(const Lesson& lesson) {
  return change_cut(lesson.before, lesson.after, lesson.region,
                    survey_change(lesson.before, lesson.after).changed, 2, 8);
}

TEST(ChangeCut, CutsTheObjectOut) {
  const DrawnLesson drawn = draw_lesson();
  const ObjectCut result = cut(drawn.lesson);
  EXPECT_GT(test::iou(result.map, drawn.truth), 0.93);
  EXPECT_EQ(result.evidence.region_touch, 0);
  EXPECT_LT(result.evidence.change_outside, 0.05);
  EXPECT_GT(result.evidence.stability, 0.9);
}

TEST(ChangeCut, NothingChangedGivesAnEmptyMap) {
  DrawnLesson drawn = draw_lesson();
  drawn.lesson.after = test::exposed(drawn.scene, 99);
  EXPECT_EQ(cv::countNonZero(cut(drawn.lesson).map), 0);
}

TEST(ChangeCut, ExposureIsNoChange) {
  DrawnLesson drawn = draw_lesson();
  const cv::Mat plain = cut(drawn.lesson).map;
  drawn.lesson.after = test::exposed(drawn.platform, 12, 1.2);
  EXPECT_GT(test::iou(cut(drawn.lesson).map, plain), 0.95);
}

TEST(ChangeCut, AShadowIsNotTheObject) {
  DrawnLesson drawn = draw_lesson();
  cv::Mat shadow, softened;
  const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1, 0, 12, 0, 1, 10);
  cv::warpAffine(drawn.truth, shadow, shift, shadow.size());
  shadow.convertTo(softened, CV_32FC1, -0.4 / 255, 1);
  cv::GaussianBlur(softened, softened, {}, 2);
  cv::Mat light, lit;
  cv::merge(std::vector<cv::Mat>(3, softened), light);
  cv::multiply(drawn.platform, light, lit);
  drawn.scene.copyTo(lit, drawn.truth);
  drawn.lesson.before = test::exposed(lit, 11);
  EXPECT_GT(test::iou(cut(drawn.lesson).map, drawn.truth), 0.85);
}

// As dark as a shadow everywhere, but the platform's texture is missing.
TEST(ChangeCut, AnObjectOfAShadowsColourIsNoShadow) {
  DrawnLesson drawn = draw_lesson();
  drawn.platform = test::texture(drawn.platform.size(), cv::Scalar(125, 125, 125), 3, 5, 1);
  cv::Mat scene = drawn.platform.clone();
  scene.setTo(cv::Scalar::all(0.85 * 125), drawn.truth);
  drawn.lesson.before = test::exposed(scene, 11);
  drawn.lesson.after = test::exposed(drawn.platform, 12);
  EXPECT_GT(test::iou(cut(drawn.lesson).map, drawn.truth), 0.9);
}

// A shadow could explain the whole plain grey object on a brighter grey platform, but an object was
// taken away.
TEST(ChangeCut, AGreyObjectOnAGreyPlatformIsNoShadow) {
  for (const double light : {0.7, 0.8}) {
    DrawnLesson drawn = draw_lesson();
    drawn.platform.setTo(cv::Scalar::all(60));
    cv::Mat scene = drawn.platform.clone();
    scene.setTo(cv::Scalar::all(light * 60), drawn.truth);
    drawn.lesson.before = test::exposed(scene, 11);
    drawn.lesson.after = test::exposed(drawn.platform, 12);
    const ObjectCut result = cut(drawn.lesson);
    EXPECT_GT(test::iou(result.map, drawn.truth), 0.9) << light;
    EXPECT_TRUE(result.evidence.shadow_like) << light;
  }
  EXPECT_FALSE(cut(draw_lesson().lesson).evidence.shadow_like);
}

// Four pixels wide and hardly brighter than the platform: a long outline and a small area.
DrawnLesson draw_faint_hook() {
  DrawnLesson drawn = draw_lesson();
  drawn.truth.setTo(0);
  cv::ellipse(drawn.truth, {100, 90}, {22, 22}, 0, 90, 360, cv::Scalar(255), 4);
  cv::ellipse(drawn.truth, {144, 90}, {22, 22}, 0, -90, 180, cv::Scalar(255), 4);
  drawn.platform = test::texture(drawn.platform.size(), cv::Scalar(110, 115, 120), 6, 1);
  drawn.scene = drawn.platform.clone();
  drawn.scene.setTo(cv::Scalar(119, 124, 129), drawn.truth);
  cv::GaussianBlur(drawn.scene, drawn.scene, {}, 0.7);
  drawn.lesson.before = test::exposed(drawn.scene, 11, 1, 3);
  drawn.lesson.after = test::exposed(drawn.platform, 12, 1, 3);
  drawn.lesson.region = cv::Rect(60, 50, 125, 80);
  return drawn;
}

TEST(ChangeCut, CutOffGrowsWithTheCutObjectAndNotWithItsShadow) {
  DrawnLesson drawn = draw_lesson();
  cv::Rect& region = drawn.lesson.region;
  region = cv::boundingRect(drawn.truth);
  EXPECT_EQ(cut(drawn.lesson).evidence.cut_off, 0) << "close around it";
  const cv::Rect right(region.br().x, region.y, 30, region.height);
  cv::Mat(drawn.scene, right) *= 0.5;
  drawn.lesson.before = test::exposed(drawn.scene, 11);
  EXPECT_LT(cut(drawn.lesson).evidence.cut_off, 0.03) << "with a shadow beside the region";
  region.width = region.width * 7 / 10;
  EXPECT_GT(cut(drawn.lesson).evidence.cut_off, 0.1);
}

TEST(ChangeCut, AThinFaintHookIsKept) {
  const DrawnLesson drawn = draw_faint_hook();
  EXPECT_GT(test::iou(cut(drawn.lesson).map, drawn.truth), 0.8);
}

// A correction of the map must not worsen the verdict.
TEST(ChangeCut, StrokesImproveTheEvidence) {
  const DrawnLesson drawn = draw_faint_hook();
  const ObjectCut first = cut(drawn.lesson);
  cv::Mat beside, include = drawn.truth.clone();
  cv::dilate(drawn.truth, beside, cv::Mat::ones(15, 15, CV_8U));
  include.colRange(120, include.cols).setTo(0);
  const ObjectCut mended = first.cut_again(include, beside & ~drawn.truth);
  EXPECT_GT(test::iou(mended.map, drawn.truth), test::iou(first.map, drawn.truth));
  EXPECT_GT(mended.evidence.stability, first.evidence.stability);
  EXPECT_GT(mended.evidence.boundary_contrast, first.evidence.boundary_contrast);
}

// Pixels just outside are included about as often as pixels just inside are left out.
TEST(ChangeCut, TheOutlineIsUnbiased) {
  const DrawnLesson drawn = draw_lesson();
  const cv::Mat map = cut(drawn.lesson).map;
  const int added = cv::countNonZero(map & ~drawn.truth);
  const int missed = cv::countNonZero(drawn.truth & ~map);
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(drawn.truth, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  EXPECT_LT(std::abs(added - missed), 0.25 * static_cast<double>(outlines[0].size()));
}

TEST(ChangeCut, HolesShowThePlatform) {
  DrawnLesson drawn = draw_lesson();
  const cv::Rect hole(104, 84, 18, 16);
  cv::Mat scene = drawn.scene.clone();
  drawn.platform(hole).copyTo(scene(hole));
  drawn.lesson.before = test::exposed(scene, 11);
  const cv::Mat map = cut(drawn.lesson).map;
  EXPECT_LT(cv::countNonZero(map(hole)), 0.2 * hole.area());
}

// If the object is put aside inside the region, its new place must not be added to the map.
TEST(ChangeCut, TheNewPlaceIsNotPartOfTheMap) {
  DrawnLesson drawn = draw_lesson({80, 100}, {320, 240});
  const cv::Mat elsewhere = test::wedge_map({320, 240}, {220, 120});
  cv::Mat scene = drawn.platform.clone();
  test::texture({320, 240}, cv::Scalar(60, 90, 190), 22, 2).copyTo(scene, elsewhere);
  drawn.lesson.after = test::exposed(scene, 12);
  drawn.lesson.region = cv::Rect(20, 40, 270, 140);
  const ObjectCut result = cut(drawn.lesson);
  EXPECT_GT(test::iou(result.map, drawn.truth), 0.9);
}

// Pixels outside the region's surroundings have no effect.
TEST(ChangeCut, FarPixelsDoNotMatter) {
  DrawnLesson drawn = draw_lesson({70, 70}, {360, 280});
  const cv::Mat nothing = cv::Mat::zeros(drawn.truth.size(), CV_8UC1);
  const auto map_of = [&] {
    return change_cut(drawn.lesson.before, drawn.lesson.after, drawn.lesson.region, nothing, 2, 8)
        .map;
  };
  const cv::Mat first = map_of();
  drawn.lesson.after(cv::Rect(300, 220, 60, 60)).setTo(cv::Scalar(0, 0, 255));
  EXPECT_EQ(cv::countNonZero(first != map_of()), 0);
}

}  // namespace
}  // namespace mbncc
