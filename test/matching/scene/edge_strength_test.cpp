// SPDX-License-Identifier: BSD-3-Clause
// Lengths of edge vectors in different light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>

#include "imaging/gradient_orientation.hpp"

namespace mbncc::imaging {
namespace {

constexpr double kSigma = 0.8;
const cv::Size kSize(60, 40);

/// Longest edge vector [0..1] of a step from `dark` to `bright` [levels].
double step_response(double dark, double bright, const cv::Scalar& colour = {1, 1, 1}) {
  cv::Mat image(kSize, CV_8UC3, colour * dark);
  image.colRange(kSize.width / 2, kSize.width) = colour * bright;
  cv::Mat smooth(kSize, CV_8UC3), edges(kSize, CV_8SC2);
  smooth_and_find_edges(image, {{}, kSize}, kSigma, smooth, edges);
  double longest = 0;
  for (int x = 0; x < kSize.width; ++x) {
    const auto edge = edges.at<cv::Vec<std::int8_t, 2>>(kSize.height / 2, x);
    longest = std::max(longest, std::hypot(edge[0], edge[1]) / kEdgeScale);
  }
  return longest;
}

TEST(EdgeStrength, GrowsWithContrast) {
  EXPECT_NEAR(step_response(120, 120), 0, 0.01);
  EXPECT_LT(step_response(120, 126), step_response(120, 140));
  EXPECT_LT(step_response(120, 140), step_response(120, 200));
}

// Half of the light halves the contrast in grey levels, but not the contrast of the surfaces.
TEST(EdgeStrength, HardlyDependsOnTheLight) {
  const double full = step_response(120, 180);
  EXPECT_GT(full, 0.75);
  EXPECT_NEAR(step_response(60, 90), full, 0.1);
  EXPECT_NEAR(step_response(40, 60), full, 0.17);
}

TEST(EdgeStrength, StaysSmallForNoiseInTheDark) {
  EXPECT_LT(step_response(10, 13), 0.5);
}

TEST(EdgeStrength, IsSmallerForTheSameStepInBrightLight) {
  EXPECT_GT(step_response(20, 40), step_response(220, 240) + 0.08);
}

TEST(EdgeStrength, FollowsTheBrightestChannel) {
  EXPECT_NEAR(step_response(120, 180, {0, 0, 1}), step_response(120, 180), 0.01);
}

}  // namespace
}  // namespace mbncc::imaging
