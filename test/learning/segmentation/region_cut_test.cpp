// SPDX-License-Identifier: BSD-3-Clause
// Lessons from one image: the platform is predicted, and the rim is classified by the colours on
// both sides.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <string>

#include "learning/images.hpp"
#include "learning/likelihood/predicted_platform.hpp"
#include "learning/likelihood/rim_preference.hpp"
#include "learning/teaching/segmenter.hpp"
#include "mbncc/learning/region_cut.hpp"

namespace mbncc {
namespace {

const cv::Size kSize(200, 160);
const cv::Rect kObject(70, 60, 50, 40), kRegion(55, 45, 85, 75);
const cv::Point kCentre(95, 82);

cv::Mat truth() {
  cv::Mat mask = cv::Mat::zeros(kSize, CV_8UC1);
  mask(kObject).setTo(255);
  return mask;
}

// A table whose light falls off to the right and downwards.
cv::Mat table() {
  cv::Mat image(kSize, CV_32FC3);
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      const float light = 200 - x / 3.F - y * y / 400.F;
      image.at<cv::Vec3f>(y, x) = cv::Vec3f(light - 20, light, light + 20);
    }
  return image;
}

cv::Mat scene(const cv::Scalar& colour) {
  cv::Mat image = table();
  image(kObject).setTo(colour);
  cv::GaussianBlur(image, image, {}, 0.8);
  return test::exposed(image, 3);
}

TEST(PredictedPlatform, FollowsTheLightAndExcludesNeighbours) {
  cv::Mat image = scene({40, 40, 200});
  image(cv::Rect(48, 60, 6, 40)).setTo(cv::Scalar(10, 200, 10));
  const alignment::AlignedPair pair = likelihood::predict_platform(image, kRegion);
  cv::Mat wanted, difference;
  table()(pair.window).convertTo(wanted, CV_32F);
  cv::absdiff(pair.after, wanted, difference);
  double most = 0;
  cv::minMaxLoc(difference.reshape(1), nullptr, &most);
  EXPECT_LT(most, 6);
  const cv::Point neighbour = cv::Point(50, 80) - pair.window.tl(),
                  platform = cv::Point(145, 80) - pair.window.tl();
  EXPECT_EQ(pair.trusted.at<uchar>(neighbour), 0);
  EXPECT_EQ(pair.trusted.at<uchar>(platform), 255);
}

TEST(RegionCut, CutsAPlainObjectOnAPlainTable) {
  for (const cv::Scalar& colour : {cv::Scalar(40, 40, 200), cv::Scalar(30, 30, 30),
                                   cv::Scalar(250, 250, 250), cv::Scalar(120, 160, 190)}) {
    const ObjectCut cut = region_cut(scene(colour), kRegion, 2);
    EXPECT_GT(test::iou(cut.map, truth()), 0.95) << colour;
  }
}

TEST(RegionCut, IsNoLargerForALargerRegion) {
  const ObjectCut cut = region_cut(scene({40, 40, 200}), {20, 20, 150, 125}, 2);
  EXPECT_GT(test::iou(cut.map, truth()), 0.95);
}

TEST(RegionCut, IsEmptyForAnEmptyTable) {
  const ObjectCut cut = region_cut(test::exposed(table(), 4), kRegion, 2);
  EXPECT_EQ(cv::countNonZero(cut.map), 0);
  EXPECT_EQ(cut.evidence.region_span, 0);
}

TEST(RegionCut, WorksWithoutARing) {
  const cv::Mat image = scene({40, 40, 200});
  const ObjectCut cut = region_cut(image, {0, 0, kSize.width, kSize.height}, 2);
  EXPECT_EQ(cut.map.size(), image.size());
}

// A rim pixel belongs to the side whose colour contributes more to it.
TEST(RimPreference, FollowsTheLargerShareOfTheMixture) {
  cv::Mat before(kSize, CV_32FC3, cv::Scalar(180, 180, 180)), after = before.clone();
  before(kObject).setTo(cv::Scalar(40, 40, 220));
  const auto mixed = [&](int x, float object) {
    before(cv::Rect(x, kObject.y, 1, kObject.height)) =
        cv::Scalar(180, 180, 180) * (1 - object) + cv::Scalar(40, 40, 220) * object;
  };
  mixed(kObject.x - 1, 0.3F);
  mixed(kObject.x, 0.7F);
  const likelihood::RimPreference rim = likelihood::rim_preference(before, after, truth(), 1);
  const int y = kObject.y + kObject.height / 2;
  EXPECT_LT(rim.log_odds.at<float>(y, kObject.x - 1), -1);
  EXPECT_GT(rim.log_odds.at<float>(y, kObject.x), 1);
  EXPECT_EQ(rim.valid.at<uchar>(y, kObject.x + 10), 0) << "far from the outline nothing is sampled";
}

TEST(RimPreference, IsUndecidedForEqualSidesAndAThirdColour) {
  cv::Mat before(kSize, CV_32FC3, cv::Scalar(180, 180, 180)), after = before.clone();
  EXPECT_EQ(cv::countNonZero(likelihood::rim_preference(before, after, truth(), 1).valid), 0);
  before(kObject).setTo(cv::Scalar(40, 40, 220));
  before(cv::Rect(kObject.x, kObject.y, 1, kObject.height)).setTo(cv::Scalar(20, 220, 20));
  const likelihood::RimPreference rim = likelihood::rim_preference(before, after, truth(), 1);
  EXPECT_EQ(rim.valid.at<uchar>(kObject.y + 20, kObject.x), 0);
}

// A scene on squares of two colours; `side` in px.
cv::Mat scene_on_squares(int side) {
  cv::Mat image = table();
  for (int y = 0; y < kSize.height; y += side)
    for (int x = 0; x < kSize.width; x += side)
      if ((x / side + y / side) % 2 == 1)
        image(cv::Rect(x, y, side, side) & cv::Rect({0, 0}, kSize)).setTo(cv::Scalar(50, 70, 60));
  image(kObject).setTo(cv::Scalar(40, 40, 200));
  cv::GaussianBlur(image, image, {}, 0.8);
  return test::exposed(image, 5);
}

// The cut of the default method for one image.
teaching::Segmentation cut_of(const cv::Mat& image, const cv::Rect& region) {
  const StageObserver silent;
  teaching::LessonProgress progress(silent);
  teaching::SegmentationTask task;
  task.before = image;
  task.region = region;
  return teaching::segmenter_of("auto", false)(task, {}, progress);
}

TEST(OneImage, TheCutWithTheClearerOutlineIsChosen) {
  const teaching::Segmentation small = cut_of(scene_on_squares(20), kRegion);
  EXPECT_GT(test::iou(small.map, truth()), 0.95) << "GrabCut takes squares for the object";
  const teaching::Segmentation large = cut_of(scene_on_squares(60), {62, 52, 66, 56});
  EXPECT_GT(test::iou(large.map, truth()), 0.85) << "the region cut takes a square for the object";
}

TEST(OneImage, StabilityIsTheAgreementOfTheTwoCuts) {
  const teaching::Segmentation plain = cut_of(scene({40, 40, 200}), kRegion);
  EXPECT_GT(plain.evidence->stability, 0.9);
  EXPECT_FALSE(plain.evidence->verified);
  EXPECT_LT(cut_of(scene_on_squares(20), kRegion).evidence->stability, 0.8);
}

// A dark disc whose middle has the table's colours, multiplied by `tint`.
cv::Mat ringed_scene(const cv::Scalar& tint) {
  cv::Mat image = table(), tinted, part = cv::Mat::zeros(kSize, CV_8UC1);
  cv::multiply(table(), tint, tinted);
  cv::circle(image, kCentre, 27, cv::Scalar(40, 40, 40), cv::FILLED);
  cv::circle(part, kCentre, 19, cv::Scalar(255), cv::FILLED);
  tinted.copyTo(image, part);
  cv::GaussianBlur(image, image, {}, 0.8);
  return test::exposed(image, 7);
}

const cv::Scalar kPlatform(1, 1, 1), kPalePrint(1.05, 1, 1);

double hole_in(const cv::Mat& image) {
  return cut_of(image, {50, 45, 90, 75}).evidence->unconfirmed_hole;
}

TEST(OneImage, AHoleShowsThePredictedPlatform) {
  EXPECT_EQ(hole_in(ringed_scene(kPlatform)), 0);
  EXPECT_EQ(hole_in(scene({40, 40, 200})), 0) << "no hole";
  EXPECT_GT(hole_in(ringed_scene(kPalePrint)), 0.4);
}

TEST(OneImage, EveryMethodMeasuresItsHoles) {
  const cv::Mat image = ringed_scene(kPalePrint);
  const StageObserver silent;
  teaching::LessonProgress progress(silent);
  teaching::SegmentationTask task;
  task.before = image;
  task.region = {50, 45, 90, 75};
  task.approximate = cv::Mat::zeros(kSize, CV_8UC1);
  cv::circle(task.approximate, kCentre, 23, cv::Scalar(255), 8);
  for (const std::string method : {"region_cut", "grabcut_mask"}) {
    const teaching::Segmentation cut = teaching::segmenter_of(method, false)(task, {}, progress);
    EXPECT_GT(cut.evidence->unconfirmed_hole, 0.4) << method;
    cv::Mat exclude = cv::Mat::zeros(kSize, CV_8UC1);
    cv::circle(exclude, kCentre, 4, cv::Scalar(255), cv::FILLED);
    const teaching::Segmentation ring = cut.cut_again({cv::Mat::zeros(kSize, CV_8UC1), exclude});
    EXPECT_EQ(ring.evidence->unconfirmed_hole, 0) << method << ": the stroke says platform";
  }
}

TEST(OneImage, AStrokeDoesNotReplaceTheSecondImage) {
  cv::Mat include = cv::Mat::zeros(kSize, CV_8UC1), exclude = include.clone();
  include(cv::Rect(80, 70, 5, 5)).setTo(255);
  const ObjectCut cut = region_cut(scene({40, 40, 200}), kRegion, 2);
  EXPECT_FALSE(cut.evidence.verified);
  EXPECT_FALSE(cut.cut_again(include, exclude).evidence.verified);
}

}  // namespace
}  // namespace mbncc
