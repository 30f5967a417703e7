// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/change_map.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace mbncc {
namespace {

cv::Mat platform() {
  cv::Mat coarse(30, 40, CV_8UC3), image;
  cv::RNG random(5);
  random.fill(coarse, cv::RNG::UNIFORM, 60, 200);
  cv::resize(coarse, image, {320, 240}, 0, 0, cv::INTER_CUBIC);
  return image;
}

class ChangeMapTest : public ::testing::Test {
 protected:
  void show(const cv::Mat& image) {
    cv::Mat noise(image.size(), CV_16SC3), noisy;
    random_.fill(noise, cv::RNG::NORMAL, 0, 3);
    image.convertTo(noisy, CV_16S);
    cv::Mat(noisy + noise).convertTo(noisy, CV_8U);
    map_.update(stamp_ += 1. / 30, noisy);
  }

  static cv::Mat with_patch(const cv::Rect& patch) {
    cv::Mat image = platform();
    image(patch) = cv::Scalar(20, 30, 40);
    return image;
  }

  bool is_calm() const { return !map_.touches({0, 0, 320, 240}) && map_.settled().empty(); }

  double stamp_ = 0;  // [s]
  cv::RNG random_{3};
  ChangeMap map_;
};

TEST_F(ChangeMapTest, NoiseIsNoChange) {
  for (int i = 0; i < 50; ++i) {
    show(platform());
    EXPECT_TRUE(is_calm()) << i;
  }
}

TEST_F(ChangeMapTest, FlickerIsNoChange) {
  for (int i = 0; i < 50; ++i) {
    show(platform() * (1 + 0.05 * std::sin(i)));
    EXPECT_TRUE(is_calm()) << i;
  }
}

TEST_F(ChangeMapTest, LightThatGoesOutOrReturnsIsAGlobalChange) {
  for (int i = 0; i < 10; ++i) show(platform());
  for (const double light : {0.01, 1.0}) {
    show(platform() * light);
    EXPECT_TRUE(map_.has_changed_globally()) << light;
    for (int i = 0; i < 20; ++i) show(platform() * light);
    EXPECT_TRUE(is_calm()) << light;
  }
}

TEST_F(ChangeMapTest, LightThatDriftsSlowlyIsNoChange) {
  cv::Mat ramp(240, 320, CV_32FC3);
  for (int x = 0; x < 320; ++x) ramp.col(x).setTo(cv::Scalar::all((x - 160) / 160.));
  for (int i = 0; i < 200; ++i) {
    cv::Mat lit;
    platform().convertTo(lit, CV_32F);
    lit = lit.mul(cv::Scalar::all(1) + 0.04 * i / 200 * ramp);
    lit.convertTo(lit, CV_8U);
    show(lit);
    ASSERT_TRUE(is_calm()) << i;
  }
}

TEST_F(ChangeMapTest, APatchIsReportedOnceAfterItHasComeToRest) {
  const cv::Rect patch(100, 60, 40, 30);
  show(platform());
  show(with_patch(patch));
  EXPECT_TRUE(map_.touches(patch));
  EXPECT_FALSE(map_.touches({200, 60, 100, 100}));
  show(with_patch(patch));
  EXPECT_TRUE(map_.settled().empty()) << "it may still be moving";
  for (int i = 0; i < 2; ++i) show(with_patch(patch));
  ASSERT_EQ(map_.settled().size(), 1u);
  EXPECT_EQ(map_.settled()[0] & patch, patch);
  EXPECT_LE(map_.settled()[0].area(), 2 * patch.area());
  for (int i = 0; i < 5; ++i) {
    show(with_patch(patch));
    EXPECT_TRUE(is_calm());
  }
}

TEST_F(ChangeMapTest, SmallShiftOfAPatchIsSeen) {
  show(with_patch({100, 60, 40, 30}));
  show(with_patch({101, 60, 40, 30}));
  EXPECT_TRUE(map_.touches({90, 50, 60, 50}));
}

TEST_F(ChangeMapTest, AMovingPatchIsReportedAtIntervals) {
  show(platform());
  std::size_t told = 0;
  for (int i = 0; i < 120; ++i) {
    show(with_patch({10 + 2 * i, 100, 40, 40}));
    told += map_.settled().size();
  }
  EXPECT_GE(told, 2u);
  EXPECT_LE(told, 20u);
}

TEST_F(ChangeMapTest, APushedCameraChangesTheWholeImage) {
  show(platform());
  cv::Mat pushed;
  cv::warpAffine(platform(), pushed, cv::Matx23d(1, 0, 9, 0, 1, 5), {320, 240}, cv::INTER_LINEAR,
                 cv::BORDER_REPLICATE);
  show(pushed);
  EXPECT_TRUE(map_.has_changed_globally());
  for (int i = 0; i < 3; ++i) show(pushed);
  EXPECT_FALSE(map_.settled().empty());
  show(pushed);
  EXPECT_FALSE(map_.has_changed_globally());
  EXPECT_TRUE(is_calm());
}

TEST_F(ChangeMapTest, AnotherImageSizeRestartsTheMap) {
  show(platform());
  map_.update(stamp_ + 1, platform()({0, 0, 160, 120}));
  EXPECT_TRUE(map_.settled().empty());
  EXPECT_FALSE(map_.touches({0, 0, 160, 120}));
}

TEST_F(ChangeMapTest, AcceptsGreyImages) {
  cv::Mat grey;
  cv::cvtColor(platform(), grey, cv::COLOR_BGR2GRAY);
  map_.update(stamp_ += 1, grey);
  grey({40, 40, 60, 60}).setTo(0);
  map_.update(stamp_ += 1, grey);
  EXPECT_TRUE(map_.touches({40, 40, 60, 60}));
}

TEST_F(ChangeMapTest, RefusesUnusableImages) {
  EXPECT_THROW(map_.update(0, {}), std::invalid_argument);
  EXPECT_THROW(map_.update(0, cv::Mat(10, 10, CV_32FC1)), std::invalid_argument);
}

}  // namespace
}  // namespace mbncc
