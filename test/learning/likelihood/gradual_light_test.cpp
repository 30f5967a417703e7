// SPDX-License-Identifier: BSD-3-Clause
// Changes of light have soft borders, objects have sharp ones.
#include "learning/likelihood/gradual_light.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"
#include "mbncc/learning/change.hpp"
#include "mbncc/learning/change_cut.hpp"

namespace mbncc::likelihood {
namespace {

const cv::Size kSize(140, 120);
const cv::Rect kPatch(50, 40, 40, 40);

// CV_32FC1 image with the fraction `part` of the light in the patch, whose border is blurred.
cv::Mat light(double part, double blur) {
  cv::Mat light(kSize, CV_32FC1, cv::Scalar(1));
  light(kPatch).setTo(part);
  cv::GaussianBlur(light, light, {}, blur);
  return light;
}

cv::Mat lit(const cv::Mat& image, const cv::Mat& light) {
  cv::Mat channels[3], result;
  cv::split(image, channels);
  for (cv::Mat& channel : channels) channel = channel.mul(light);
  cv::merge(channels, 3, result);
  return result;
}

const cv::Mat kTextureVisible(kSize, CV_32FC1, cv::Scalar(-1));
const cv::Mat kNoTexture(kSize, CV_32FC1, cv::Scalar(0));

// Position of a plain bright object next to the patch.
const cv::Rect kObject(15, 20, 25, 60);

struct Scene {
  cv::Mat before, after;
  cv::Mat changed = cv::Mat::zeros(kSize, CV_32FC1);

  explicit Scene(const cv::Mat& light, const cv::Scalar& object = {40, 60, 250})
      : before(lit(platform(), light)), after(platform()) {
    before(kObject).setTo(object);
    cv::GaussianBlur(before, before, {}, 0.7);
    changed(kObject).setTo(1);
    changed(kPatch).setTo(1);
  }
  static cv::Mat platform() { return cv::Mat(kSize, CV_32FC3, cv::Scalar(130, 140, 150)); }

  // Fraction of `part` that is reached.
  double reached(const cv::Rect& part, const cv::Mat& texture_loss = kNoTexture) const {
    const cv::Mat mask = gradual_light(before, after, changed, texture_loss, 1);
    return cv::countNonZero(mask(part)) / static_cast<double>(part.area());
  }
};

TEST(GradualLight, ReachesSoftShadowsAndReflectionsButNotTheObject) {
  for (const double part : {0.8, 1.2}) {
    const Scene scene(light(part, 9));
    EXPECT_GT(scene.reached(kPatch), 0.9) << part;
    EXPECT_EQ(scene.reached(kObject), 0) << part;
  }
}

TEST(GradualLight, ASharpEdgeStopsItUnlessTextureStaysVisible) {
  const Scene scene(light(0.7, 1));
  EXPECT_EQ(scene.reached(kPatch), 0);
  EXPECT_GT(scene.reached(kPatch, kTextureVisible), 0.9);
  EXPECT_EQ(Scene(light(1.3, 1)).reached(kPatch, kTextureVisible), 0) << "no shadow is brighter";
}

TEST(GradualLight, DoesNotReachASingleFaintObject) {
  const Scene scene(light(1, 1), {115, 125, 135});
  EXPECT_EQ(scene.reached(kObject), 0);
}

TEST(GradualLight, DoesNotPassNarrowGapsInAnEdge) {
  cv::Mat heights = cv::Mat::zeros(kSize, CV_32FC1);
  cv::rectangle(heights, kPatch, cv::Scalar(10), 3);
  heights(cv::Rect(70, 36, 4, 10)).setTo(0);
  EXPECT_EQ(barrier_from_frame(heights).at<float>(60, 70), 0);
  cv::Mat edge = light(0.7, 0.7);
  edge(cv::Rect(86, 58, 8, 2)).setTo(0.7);
  EXPECT_EQ(Scene(edge).reached(kPatch), 0);
}

// The lowest barrier on the best path, computed by hand.
TEST(GradualLight, TheBarrierIsThatOfTheLowestPath) {
  cv::Mat heights = cv::Mat::zeros(9, 9, CV_32FC1);
  cv::rectangle(heights, {2, 2, 5, 5}, cv::Scalar(8), 1);
  heights.at<float>(2, 4) = 3;
  const cv::Mat barrier = barrier_from_frame(heights);
  EXPECT_NEAR(barrier.at<float>(4, 4), 3, 0.02);
  EXPECT_NEAR(barrier.at<float>(2, 2), 8, 0.02);
  EXPECT_EQ(barrier.at<float>(0, 0), 0);
  EXPECT_GT(barrier_from_frame(heights, cv::Mat(heights == heights)).at<float>(0, 0), 8)
      << "no way in from a closed frame";
}

// A grey object on a plain grey platform, whose shadow has the same colours.
TEST(GradualLight, AShadowOfTheObjectsColourIsNoPartOfTheMap) {
  const cv::Rect object(45, 40, 30, 40), region(25, 20, 90, 80);
  cv::Mat platform = test::texture(kSize, cv::Scalar::all(150), 3, 1), scene, truth;
  truth = cv::Mat::zeros(kSize, CV_8UC1);
  truth(object).setTo(255);
  cv::Mat shade(kSize, CV_32FC1, cv::Scalar(1));
  shade(cv::Rect(60, 45, 45, 40)).setTo(0.7);
  cv::GaussianBlur(shade, shade, {}, 9);
  scene = lit(platform, shade);
  test::texture(kSize, cv::Scalar::all(100), 16, 4).copyTo(scene, truth);
  cv::GaussianBlur(scene, scene, {}, 0.7);
  const cv::Mat before = test::exposed(scene, 5), after = test::exposed(platform, 6);
  const ObjectCut cut =
      change_cut(before, after, region, survey_change(before, after).changed, 2, 8);
  EXPECT_GT(test::iou(cut.map, truth), 0.85);
}

}  // namespace
}  // namespace mbncc::likelihood
