// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/platform_likeness.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"

namespace mbncc::change {
namespace {

class PlatformLikeness : public testing::Test {
 protected:
  double of(const cv::Mat& before) const {
    return platform_likeness(test::exposed(before, 11), test::exposed(platform_, 12), map_);
  }

  const cv::Size size_{160, 120};
  const cv::Mat platform_ = test::texture(size_, cv::Scalar(105, 115, 120), 14, 1);
  const cv::Mat map_ = test::wedge_map(size_, {80, 60});
};

TEST_F(PlatformLikeness, IsNearOneIfOnlyTheTextureMoved) {
  EXPECT_GT(of(test::texture(size_, cv::Scalar(105, 115, 120), 14, 9)), 0.8);
}

TEST_F(PlatformLikeness, IsNearZeroForAnotherColour) {
  EXPECT_LT(of(test::texture(size_, cv::Scalar(60, 90, 190), 14, 9)), 0.05);
}

TEST_F(PlatformLikeness, EqualsThePartThatShowsThePlatform) {
  cv::Mat before = platform_.clone();
  const cv::Mat object = test::texture(size_, cv::Scalar(60, 90, 190), 14, 9);
  const cv::Rect half(80, 0, 80, 120);
  object(half).copyTo(before(half));
  const double part = 1 - cv::countNonZero(map_(half)) / double(cv::countNonZero(map_));
  EXPECT_NEAR(of(before), part, 0.1);
}

}  // namespace
}  // namespace mbncc::change
