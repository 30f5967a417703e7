// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/exposure.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"
#include "mbncc/learning/change.hpp"

namespace mbncc::change {
namespace {

const cv::Size kSize(160, 120);

cv::Mat platform() {
  return test::texture(kSize, cv::Scalar(105, 115, 120), 14, 1);
}

/// The platform with `gain` applied to `part` of the image.
cv::Mat lit(const cv::Rect& part, double gain) {
  cv::Mat radiance = platform();
  radiance(part) *= gain;
  return test::exposed(radiance, 12);
}

TEST(Exposure, IsThatOfMostPixels) {
  const cv::Mat before = test::exposed(platform(), 11);
  const Exposure exposure = exposure_of(before, lit({0, 0, kSize.width, kSize.height}, 0.8));
  EXPECT_NEAR(exposure.mean, 1.25, 0.02);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(exposure.gain[c], 1.25, 0.02);
  EXPECT_NEAR(exposure.unevenness, 1, 0.02);
}

TEST(Exposure, ABrighterOrDarkerQuarterMakesItUneven) {
  const cv::Mat before = test::exposed(platform(), 11);
  for (const int x : {0, 80})
    for (const int y : {0, 60})
      for (const double gain : {0.7, 1.4}) {
        const Exposure exposure = exposure_of(before, lit({x, y, 80, 60}, gain));
        EXPECT_NEAR(exposure.unevenness, std::max(gain, 1 / gain), 0.05) << x << ' ' << y;
        EXPECT_NEAR(exposure.mean, 1, 0.03) << "a quarter is less than a half";
      }
}

TEST(Exposure, TheSurveyIncludesUnevenness) {
  const cv::Mat before = test::exposed(platform(), 11);
  EXPECT_GT(survey_change(before, lit({0, 0, 80, 60}, 0.7)).unevenness, 1.35);
  EXPECT_LT(survey_change(before, lit({0, 0, 160, 120}, 0.7)).unevenness, 1.05);
}

TEST(Exposure, IgnoresDarkAndSaturatedPixels) {
  cv::Mat before = test::exposed(platform(), 11), after = test::exposed(platform() * 0.8, 12);
  for (const int value : {4, 255}) {
    cv::Mat b = before.clone(), a = after.clone();
    const cv::Rect most(0, 0, 160, 80);
    b(most).setTo(cv::Scalar::all(value == 255 ? 255 : 8));
    a(most).setTo(cv::Scalar::all(value));
    EXPECT_NEAR(exposure_of(b, a).mean, 1.25, 0.03) << value;
  }
}

TEST(Exposure, IsNotEstimatedFromFewPixels) {
  cv::Mat before(kSize, CV_8UC3, cv::Scalar::all(255)), after = before.clone();
  before(cv::Rect(0, 0, 16, 16)).setTo(cv::Scalar::all(200));
  after(cv::Rect(0, 0, 16, 16)).setTo(cv::Scalar::all(100));
  const Exposure exposure = exposure_of(before, after);
  EXPECT_DOUBLE_EQ(exposure.mean, 1);
  EXPECT_DOUBLE_EQ(exposure.unevenness, 1);
}

}  // namespace
}  // namespace mbncc::change
