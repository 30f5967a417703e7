// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/frozen_image.hpp"

#include <gtest/gtest.h>

namespace mbncc {
namespace {

cv::Mat noise(std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat image(30, 41, CV_8UC3);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

TEST(FrozenImage, LiveImagesAreNeverFrozen) {
  FrozenImage frozen;
  for (int i = 1; i < 50; ++i) EXPECT_FALSE(frozen.update(noise(i)));
}

TEST(FrozenImage, FifthEqualImageIsFrozenAndAnotherThaws) {
  FrozenImage frozen;
  for (int i = 1; i <= 8; ++i) EXPECT_EQ(frozen.update(noise(1)), i >= 5) << i;
  EXPECT_FALSE(frozen.update(noise(2)));
  for (int i = 2; i <= 8; ++i) EXPECT_EQ(frozen.update(noise(2)), i >= 5) << i;
}

TEST(FrozenImage, OnePixelMakesTheDifference) {
  FrozenImage frozen;
  for (int i = 0; i < 20; ++i) {
    cv::Mat image = noise(1);
    image.at<cv::Vec3b>(29, 40)[2] ^= i % 2;
    EXPECT_FALSE(frozen.update(image));
  }
}

TEST(FrozenImage, PartsOfImagesAndOtherSizesAreCompared) {
  FrozenImage frozen;
  const cv::Mat whole = noise(1);
  for (int i = 1; i <= 6; ++i) EXPECT_EQ(frozen.update(noise(1)(cv::Rect(2, 3, 20, 10))), i >= 5);
  EXPECT_FALSE(frozen.update(whole));
}

}  // namespace
}  // namespace mbncc
