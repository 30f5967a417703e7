// SPDX-License-Identifier: BSD-3-Clause
// How much of a narrow object's pixels its background takes.
#include "matching/template/edge_mixing.hpp"

#include <gtest/gtest.h>

namespace mbncc::templates {
namespace {

const cv::Size kSize{80, 60};

/// A bent strip, `width` px wide.
cv::Mat strip(int width) {
  cv::Mat map(kSize, CV_8UC1, cv::Scalar(0));
  map(cv::Rect(20, 20, 40, width)) = 255;
  map(cv::Rect(20, 20, width, 25)) = 255;
  return map;
}

TEST(AlphaMatte, WideObjectsHideTheirBackground) {
  const MapGeometry map(strip(14));
  const AlphaMatte matte(map, 0);
  EXPECT_GT(matte.at({27, 27}).share, 0.98f);
  EXPECT_NEAR(matte.at({40, 20}).share, 0.6f, 0.15f);
}

TEST(AlphaMatte, NarrowObjectsShowIt) {
  const cv::Mat map = strip(2);
  const EdgeMixing mixture = AlphaMatte(MapGeometry(map), 0).at({45, 20});
  EXPECT_GT(mixture.share, 0.4f);
  EXPECT_LT(mixture.share, 0.75f);
  for (const auto& place : mixture.beyond) EXPECT_EQ(map.at<uchar>(cv::Point(place)), 0);
  EXPECT_LT((mixture.beyond[0].y - 20.5) * (mixture.beyond[1].y - 20.5), 0) << "not on both sides";
}

TEST(AlphaMatte, WithoutBackgroundThereIsNoMixture) {
  const MapGeometry map(cv::Mat(kSize, CV_8UC1, cv::Scalar(255)));
  EXPECT_EQ(AlphaMatte(map, 0).at({40, 30}).share, 1.f);
}

/// Colours of the template and at the same place before other backgrounds.
}  // namespace
}  // namespace mbncc::templates
