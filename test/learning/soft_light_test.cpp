// Shadows end softly, objects sharply.
#include "learning/soft_light.hpp"

#include <gtest/gtest.h>

#include "learning/pictures.hpp"
#include "mbncc/learning/change.hpp"
#include "mbncc/learning/change_cut.hpp"

namespace mbncc {
namespace {

const cv::Size kSize(140, 120);
const cv::Rect kPatch(50, 40, 40, 40);

cv::Mat patch_mask() {
  cv::Mat mask = cv::Mat::zeros(kSize, CV_8UC1);
  mask(kPatch).setTo(255);
  return mask;
}

// CV_32FC1, `part` of the light left in the patch, whose border is blurred.
cv::Mat light(double part, double blur) {
  cv::Mat light(kSize, CV_32FC1, cv::Scalar(1));
  light(kPatch).setTo(part);
  cv::GaussianBlur(light, light, {}, blur);
  return light;
}

cv::Mat lit(const cv::Mat& picture, const cv::Mat& light) {
  cv::Mat channels[3], result;
  cv::split(picture, channels);
  for (cv::Mat& channel : channels) channel = channel.mul(light);
  cv::merge(channels, 3, result);
  return result;
}

cv::Mat noisy(const cv::Mat& picture, int seed) {
  cv::Mat result;
  test::exposed(picture, seed).convertTo(result, CV_32F);
  return result;
}

// Part of the patch that is reached when its light changes like this.
double reached_part(double part, double blur) {
  const cv::Mat platform = test::texture(kSize, cv::Scalar(130, 140, 150), 6, 1);
  const cv::Mat before = noisy(lit(platform, light(part, blur)), 2), after = noisy(platform, 3);
  const cv::Mat unsure = cv::Mat::zeros(kSize, CV_32FC1);
  return cv::countNonZero(soft_shadow(before, after, unsure, 3)(kPatch)) /
         static_cast<double>(kPatch.area());
}

TEST(SoftLight, GoesOnIntoAShadowButNotAcrossASharpEdge) {
  EXPECT_GT(reached_part(0.7, 9), 0.9);
  EXPECT_LT(reached_part(0.7, 0.7), 0.1);
}

TEST(SoftLight, WhatIsBrighterIsNoShadow) {
  EXPECT_EQ(reached_part(1.5, 9), 0);
}

TEST(SoftLight, GapsInAnOutlineAreNoWayIn) {
  cv::Mat edge = light(0.7, 0.7);
  edge(cv::Rect(86, 58, 8, 4)).setTo(0.7);
  cv::GaussianBlur(edge, edge, {}, 1);
  const cv::Mat after(kSize, CV_32FC3, cv::Scalar::all(140)), before = lit(after, edge);
  const cv::Mat reached = soft_shadow(before, after, cv::Mat::zeros(kSize, CV_32FC1), 3);
  EXPECT_EQ(cv::countNonZero(reached(kPatch)), 0);
}

TEST(SoftLight, ThinDarkPartsAndSureChangeAreNoShadow) {
  const cv::Mat after(kSize, CV_32FC3, cv::Scalar::all(140)), before = lit(after, light(0.7, 9));
  cv::Mat changed = cv::Mat::zeros(kSize, CV_32FC1);
  EXPECT_GT(cv::countNonZero(soft_shadow(before, after, changed, 3)), kPatch.area());
  changed.setTo(1, patch_mask());
  EXPECT_EQ(cv::countNonZero(soft_shadow(before, after, changed, 3) & patch_mask()), 0);
  cv::Mat line(kSize, CV_32FC1, cv::Scalar(1));
  cv::line(line, {20, 30}, {120, 80}, cv::Scalar(0.9), 5);
  cv::GaussianBlur(line, line, {}, 1);
  changed.setTo(0);
  EXPECT_EQ(cv::countNonZero(soft_shadow(lit(after, line), after, changed, 3)), 0);
}

// Grey object on a plain grey platform, whose shadow has its colours.
TEST(SoftLight, AShadowOfTheObjectsColourIsNoPartOfTheMap) {
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
  const ChangeCut cut =
      change_cut(before, after, region, survey_change(before, after).changed, 2, 8);
  EXPECT_GT(test::iou(cut.map, truth), 0.85);
}

}  // namespace
}  // namespace mbncc
