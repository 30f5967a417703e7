// SPDX-License-Identifier: BSD-3-Clause
// Holes of a map that may be parts of the object with the platform's colour.
#include "learning/segmentation/unconfirmed_hole.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "learning/images.hpp"

namespace mbncc::segmentation {
namespace {

const cv::Size kSize(160, 120);
const cv::Rect kObject(40, 20, 80, 80), kHole(60, 40, 40, 40);
constexpr double kPart = 40 * 40 / (80. * 80);  // of the filled map

class UnconfirmedHoleTest : public testing::Test {
 protected:
  UnconfirmedHoleTest() {
    map_(kObject).setTo(255);
    map_(kHole).setTo(0);
  }

  /// `light`: what a shadow leaves in the hole. A part of the object shows `cover` there instead of
  /// the platform.
  double part(const cv::Mat& platform, double light, const cv::Mat& cover = {}) const {
    cv::Mat scene = platform.clone(), before, after;
    scene(kObject).setTo(cv::Scalar(30, 30, 30));
    scene(kHole) = (cover.empty() ? platform : cover)(kHole)*light;
    test::exposed(scene, 11).convertTo(before, CV_32F);
    test::exposed(platform, 12).convertTo(after, CV_32F);
    return unconfirmed_hole(map_, before, after, excluded_);
  }

  cv::Mat map_ = cv::Mat::zeros(kSize, CV_8UC1), excluded_;
  const cv::Mat plain_ = cv::Mat(kSize, CV_32FC3, cv::Scalar(190, 200, 205));
  const cv::Mat textured_ = test::texture(kSize, cv::Scalar(105, 115, 120), 20, 5, 2);
};

TEST_F(UnconfirmedHoleTest, APlainPlatformOfTheSameColourConfirmsIt) {
  EXPECT_EQ(part(plain_, 1), 0);
}

TEST_F(UnconfirmedHoleTest, NothingConfirmsAPlainDarkerHole) {
  EXPECT_NEAR(part(plain_, 0.85), kPart, 1e-9);
}

TEST_F(UnconfirmedHoleTest, OneOtherChannelIsAnotherColour) {
  const cv::Mat yellowish(kSize, CV_32FC3, cv::Scalar(175, 200, 205));
  EXPECT_NEAR(part(plain_, 1, yellowish), kPart, 1e-9);
}

TEST_F(UnconfirmedHoleTest, TextureInAShadowConfirmsIt) {
  EXPECT_EQ(part(textured_, 0.7), 0);
}

TEST_F(UnconfirmedHoleTest, OtherTextureDoesNot) {
  const cv::Mat other = test::texture(kSize, cv::Scalar(105, 115, 120), 20, 9, 2);
  EXPECT_NEAR(part(textured_, 0.7, other), kPart, 1e-9);
}

// Under one lamp, a plain part and the platform below it have the same gradient.
TEST_F(UnconfirmedHoleTest, TheGradientOfTheLightIsNoTexture) {
  cv::Mat lit = plain_.clone();
  for (int x = 0; x < lit.cols; ++x) lit.col(x) *= 1 - 0.004 * x;
  EXPECT_NEAR(part(lit, 0.85), kPart, 1e-9);
}

TEST_F(UnconfirmedHoleTest, AStrokeConfirmsIt) {
  excluded_ = cv::Mat::zeros(kSize, CV_8UC1);
  excluded_(cv::Rect(30, 10, 5, 5)).setTo(255);
  EXPECT_NEAR(part(plain_, 0.85), kPart, 1e-9) << "beside the object";
  excluded_.at<uchar>(kHole.y + 1, kHole.x + 20) = 255;
  EXPECT_NEAR(part(plain_, 0.85), kPart, 1e-9) << "on the rim, as when the outline is corrected";
  excluded_.at<uchar>(kHole.y + 6, kHole.x + 20) = 255;
  EXPECT_EQ(part(plain_, 0.85), 0);
}

TEST_F(UnconfirmedHoleTest, AStrokeThroughAPartOfAHoleSettlesAllOfIt) {
  EXPECT_NEAR(enclosed_part(map_, {}), kPart, 1e-9);
  cv::Mat excluded = cv::Mat::zeros(kSize, CV_8UC1);
  excluded.at<uchar>(kHole.y + 6, kHole.x + 20) = 255;
  EXPECT_EQ(enclosed_part(map_, excluded), 0);
}

TEST_F(UnconfirmedHoleTest, ABayIsNoHole) {
  map_(cv::Rect(kHole.x, 0, kHole.width, kHole.y)).setTo(0);
  EXPECT_EQ(part(plain_, 0.85), 0);
}

// As of a part with two windows, or a hole that a stroke has divided.
TEST_F(UnconfirmedHoleTest, HolesAddUp) {
  map_(cv::Rect(kHole.x, 58, kHole.width, 4)).setTo(255);
  EXPECT_NEAR(part(plain_, 0.85), 40 * 36 / (80. * 80), 1e-9);
}

TEST_F(UnconfirmedHoleTest, AHoleWithoutInnerPixelsShowsNothing) {
  map_(kObject).setTo(255);
  map_(cv::Rect(60, 40, 9, 9)).setTo(0);
  EXPECT_EQ(part(plain_, 0.85), 0);
}

}  // namespace
}  // namespace mbncc::segmentation
