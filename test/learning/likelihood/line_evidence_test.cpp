// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/line_evidence.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace mbncc::likelihood {
namespace {

constexpr float kNone = -3;

cv::Mat drawn(const cv::Point& from, const cv::Point& to, int width, float object) {
  cv::Mat preference(60, 80, CV_32FC1, cv::Scalar(-2));
  cv::line(preference, from, to, cv::Scalar(object), width);
  return preference;
}

TEST(LineEvidence, AddsUpAlongThinPartsOfAnyDirection) {
  const cv::Point middle(40, 30);
  for (const cv::Point reach : {cv::Point(20, 0), cv::Point(0, 20), cv::Point(15, 15),
                                cv::Point(15, -15), cv::Point(18, 8), cv::Point(8, -18)}) {
    const cv::Mat lines = line_evidence(drawn(middle - reach, middle + reach, 3, 1)).parts;
    EXPECT_GT(lines.at<float>(middle), 0.7F) << reach;
  }
}

TEST(LineEvidence, BridgesAPixelThatLooksLikePlatform) {
  cv::Mat preference = drawn({20, 30}, {60, 30}, 3, 2);
  preference.at<float>(30, 40) = -3;
  EXPECT_GT(line_evidence(preference).parts.at<float>(30, 40), 1);
}

TEST(LineEvidence, GapsEqualThePartsOfTheOtherSide) {
  const cv::Mat part = drawn({20, 30}, {60, 30}, 3, 2);
  const cv::Rect inner(20, 15, 40, 30);  // beyond the image there is platform, for both sides
  const cv::Mat difference = line_evidence(-part).gaps(inner) - line_evidence(part).parts(inner);
  EXPECT_LT(cv::norm(difference, cv::NORM_INF), 1e-5);
  EXPECT_EQ(line_evidence(part).gaps.at<float>(30, 40), kNone);
}

TEST(LineEvidence, FindsNoLinesOnThePlatformOrWithinWideParts) {
  const cv::Mat lines = line_evidence(drawn({20, 30}, {60, 30}, 25, 2)).parts;
  EXPECT_EQ(lines.at<float>(30, 40), kNone);
  EXPECT_LT(lines.at<float>(5, 5), 0);
}

TEST(LineEvidence, LimitsTheInfluenceOfOnePixel) {
  cv::Mat preference(60, 80, CV_32FC1, cv::Scalar(-2));
  preference.at<float>(30, 40) = 1000;
  EXPECT_LT(line_evidence(preference).parts.at<float>(30, 40), 0);
}

TEST(LineEvidence, KeepsTheSizeOfSmallAndBorderedImages) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(3, 40), cv::Size(5, 5)}) {
    const LineEvidence lines = line_evidence(cv::Mat::ones(size, CV_32FC1));
    for (const cv::Mat& one : {lines.parts, lines.gaps}) {
      ASSERT_EQ(one.size(), size);
      EXPECT_TRUE(cv::checkRange(one, true, nullptr, kNone, -kNone));
    }
  }
}

TEST(LineEvidence, TurnsWithTheImage) {
  cv::Mat preference = drawn({10, 20}, {60, 45}, 3, 1.5F), turned;
  cv::rotate(line_evidence(preference).parts, turned, cv::ROTATE_180);
  cv::rotate(preference, preference, cv::ROTATE_180);
  EXPECT_LT(cv::norm(line_evidence(preference).parts, turned, cv::NORM_INF), 1e-5);
}

}  // namespace
}  // namespace mbncc::likelihood
