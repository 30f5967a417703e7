// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/frozen_picture.hpp"

#include <gtest/gtest.h>

namespace mbncc {
namespace {

cv::Mat noise(std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat picture(30, 41, CV_8UC3);
  random.fill(picture, cv::RNG::UNIFORM, 0, 256);
  return picture;
}

TEST(FrozenPicture, LivePicturesAreNeverFrozen) {
  FrozenPicture frozen;
  for (int i = 1; i < 50; ++i) EXPECT_FALSE(frozen.update(noise(i)));
}

TEST(FrozenPicture, FifthEqualPictureIsFrozenAndAnotherThaws) {
  FrozenPicture frozen;
  for (int i = 1; i <= 8; ++i) EXPECT_EQ(frozen.update(noise(1)), i >= 5) << i;
  EXPECT_FALSE(frozen.update(noise(2)));
  for (int i = 2; i <= 8; ++i) EXPECT_EQ(frozen.update(noise(2)), i >= 5) << i;
}

TEST(FrozenPicture, OnePixelMakesTheDifference) {
  FrozenPicture frozen;
  for (int i = 0; i < 20; ++i) {
    cv::Mat picture = noise(1);
    picture.at<cv::Vec3b>(29, 40)[2] ^= i % 2;
    EXPECT_FALSE(frozen.update(picture));
  }
}

TEST(FrozenPicture, PartsOfPicturesAndOtherSizesAreCompared) {
  FrozenPicture frozen;
  const cv::Mat whole = noise(1);
  for (int i = 1; i <= 6; ++i) EXPECT_EQ(frozen.update(noise(1)(cv::Rect(2, 3, 20, 10))), i >= 5);
  EXPECT_FALSE(frozen.update(whole));
}

TEST(FrozenPicture, ResetForgets) {
  FrozenPicture frozen;
  for (int i = 0; i < 5; ++i) frozen.update(noise(1));
  frozen.reset();
  EXPECT_FALSE(frozen.update(noise(1)));
}

}  // namespace
}  // namespace mbncc
