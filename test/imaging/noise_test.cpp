// SPDX-License-Identifier: BSD-3-Clause
#include "imaging/noise.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace mbncc::imaging {
namespace {

const cv::Size kSize(200, 160);
const cv::Rect kBright(100, 0, 100, 160);

/// Two halves.
cv::Mat with_edge() {
  cv::Mat image(kSize, CV_8UC3, cv::Scalar(60, 70, 80));
  image(kBright).setTo(cv::Scalar(120, 130, 140));
  return image;
}

cv::Mat noisy(const cv::Mat& image, double deviation) {
  cv::Mat noise(image.size(), CV_16SC3), sum;
  cv::RNG(5).fill(noise, cv::RNG::NORMAL, 0, deviation);
  cv::add(image, noise, sum, cv::noArray(), CV_8U);
  return sum;
}

double deviation_of(const cv::Mat& flat) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(flat, mean, deviation);
  return deviation[1];
}

TEST(Noise, IsMeasuredBesideEdges) {
  EXPECT_EQ(noise_deviation(with_edge()), 0);
  for (const double deviation : {2., 6., 15.})
    EXPECT_NEAR(noise_deviation(noisy(with_edge(), deviation)), deviation, 0.1 * deviation);
}

TEST(Noise, IsThatOfTheNoisiestChannel) {
  std::vector<cv::Mat> channels;
  cv::split(with_edge(), channels);
  cv::Mat image;
  cv::extractChannel(noisy(with_edge(), 8), channels[0], 0);
  cv::merge(channels, image);
  EXPECT_NEAR(noise_deviation(image), 8, 0.8);
}

TEST(Noise, IsMeasuredUnderTheMaskAlone) {
  cv::Mat image = noisy(with_edge(), 8), mask = cv::Mat::zeros(kSize, CV_8UC1);
  with_edge()(kBright).copyTo(image(kBright));
  mask(kBright).setTo(255);
  EXPECT_EQ(noise_deviation(image, mask), 0);
  EXPECT_NEAR(noise_deviation(image, ~mask), 8, 0.8);
}

TEST(Noise, LittleIsKept) {
  const cv::Mat image = noisy(with_edge(), 2);
  EXPECT_EQ(without_noise(image, 2).data, image.data);
  EXPECT_NE(without_noise(image, 3).data, image.data);
}

TEST(Noise, IsRemovedBetweenEdgesAlone) {
  const cv::Mat image = noisy(with_edge(), 8), smooth = without_noise(image, 8);
  EXPECT_LT(deviation_of(smooth(cv::Rect(10, 10, 80, 140))), 0.6 * 8);
  for (const int beside : {99, 100}) {
    const double truth = with_edge().at<cv::Vec3b>(0, beside)[1];
    EXPECT_NEAR(cv::mean(smooth.col(beside))[1], truth, 6) << "the edge stays within its pixel";
  }
}

}  // namespace
}  // namespace mbncc::imaging
