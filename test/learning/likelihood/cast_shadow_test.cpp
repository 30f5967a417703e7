// SPDX-License-Identifier: BSD-3-Clause
// A dark patch is a shadow where the platform's texture stays visible in it.
#include "learning/likelihood/cast_shadow.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"
#include "mbncc/learning/change.hpp"
#include "mbncc/learning/change_cut.hpp"

namespace mbncc::likelihood {
namespace {

const cv::Size kSize(200, 160);
const cv::Scalar kStone(140, 150, 155);
const cv::Rect kPatch(60, 50, 60, 40);

cv::Mat stone(int seed = 1, double contrast = 14) {
  return test::texture(kSize, kStone, contrast, seed, 1.5);
}

cv::Mat seen(const cv::Mat& radiance, int seed) {
  cv::Mat image;
  test::exposed(radiance, seed).convertTo(image, CV_32F);
  return image;
}

// Part of `patch` that counts as shadow.
double shadow_part(const cv::Mat& before, const cv::Mat& after, const cv::Rect& patch = kPatch) {
  const cv::Mat shadow = cast_shadow(seen(before, 3), seen(after, 4));
  return cv::countNonZero(shadow(patch)) / static_cast<double>(patch.area());
}

TEST(CastShadow, TheTextureStaysVisible) {
  for (const double light : {0.35, 0.5, 0.8}) {
    cv::Mat before = stone();
    before(kPatch) *= light;
    EXPECT_GT(shadow_part(before, stone()), 0.9) << light;
    EXPECT_LT(cv::countNonZero(cast_shadow(seen(before, 3), seen(stone(), 4))),
              1.05 * kPatch.area());
  }
}

TEST(CastShadow, APlainOrOtherwiseTexturedPatchIsNone) {
  cv::Mat plain = stone(), other = stone(), inverted = stone();
  plain(kPatch).setTo(0.5 * kStone);
  cv::Mat(0.5 * stone(2))(kPatch).copyTo(other(kPatch));
  inverted(kPatch) = 1.5 * kStone - inverted(kPatch);
  for (const cv::Mat& before : {plain, other, inverted}) EXPECT_EQ(shadow_part(before, stone()), 0);
}

TEST(CastShadow, AnotherColourIsNone) {
  cv::Mat before = stone();
  cv::multiply(before(kPatch), cv::Scalar(0.3, 0.5, 0.7), before(kPatch));
  EXPECT_EQ(shadow_part(before, stone()), 0);
}

TEST(CastShadow, APlainPlatformTellsNothing) {
  cv::Mat before = stone(1, 0);
  before(kPatch) *= 0.5;
  EXPECT_EQ(shadow_part(before, stone(1, 0)), 0);
}

TEST(CastShadow, ShadowsOfDifferentLightAreFound) {
  const cv::Rect deep(10, 10, 40, 30), faint(140, 100, 50, 50);
  cv::Mat before = stone();
  before(kPatch) *= 0.6;
  before(deep) *= 0.3;
  before(faint) *= 0.8;
  for (const cv::Rect& patch : {kPatch, deep, faint})
    EXPECT_GT(shadow_part(before, stone(), patch), 0.85) << patch;
}

TEST(CastShadow, AFewPixelsAreNoEvidence) {
  const cv::Rect few(60, 50, 12, 12);
  cv::Mat before = stone(1, 4);
  before(few) *= 0.6;
  EXPECT_EQ(shadow_part(before, stone(1, 4), few), 0);
}

TEST(CastShadow, IsNoPartOfAMap) {
  const cv::Rect object(90, 60, 20, 44), beside(58, 68, 84, 62);  // partly under the object
  cv::Mat truth = cv::Mat::zeros(kSize, CV_8UC1), before = stone();
  truth(object).setTo(255);
  before(beside) *= 0.4;
  before(object).setTo(cv::Scalar(90, 95, 100));
  cv::GaussianBlur(before, before, {}, 0.8);
  const cv::Mat seen = test::exposed(before, 1), after = test::exposed(stone(), 2);
  const cv::Mat changed = survey_change(seen, after).changed;
  EXPECT_GT(test::iou(change_cut(seen, after, {40, 44, 110, 96}, changed, 2, 8).map, truth), 0.9);
}

}  // namespace
}  // namespace mbncc::likelihood
