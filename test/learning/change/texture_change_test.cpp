// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/texture_change.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"

namespace mbncc::change {
namespace {

constexpr double kWhite = 255;
const cv::Size kSize(160, 120);

/// CV_32FC1 texture with about the given mean brightness.
cv::Mat grey(double brightness, double contrast, int seed = 1, double grain = 3) {
  cv::Mat one;
  cv::extractChannel(test::texture(kSize, cv::Scalar::all(brightness), contrast, seed, grain), one,
                     0);
  return one;
}

cv::Mat noisy(const cv::Mat& image, double sigma, int seed) {
  cv::Mat noise(image.size(), CV_32FC1);
  cv::RNG(seed).fill(noise, cv::RNG::NORMAL, 0, sigma);
  return image + noise;
}

TEST(TextureChange, ContrastDependsOnTheGainAndNotOnTheOffset) {
  const cv::Mat before = grey(120, 15);
  EXPECT_NEAR(texture_change(before, before * 0.8, kWhite).contrast, 1 / 0.8, 0.01);
  EXPECT_NEAR(texture_change(before, before - 20, kWhite).contrast, 1, 0.01);
  EXPECT_DOUBLE_EQ(texture_change(before, before * 0.8, kWhite).displaced, 0);
}

TEST(TextureChange, NoiseAddsNoContrastToStrongTexture) {
  // One half has strong texture under half of the light, the other so little that noise resembles
  // it.
  cv::Mat before = grey(100, 5.5, 1, 1.5), after = before * 0.5;
  grey(100, 20)(cv::Rect(0, 0, 60, 120)).copyTo(before(cv::Rect(0, 0, 60, 120)));
  cv::Mat(grey(50, 10)(cv::Rect(0, 0, 60, 120))).copyTo(after(cv::Rect(0, 0, 60, 120)));
  EXPECT_NEAR(texture_change(noisy(before, 8, 3), noisy(after, 8, 4), kWhite).contrast, 2, 0.15);
}

TEST(TextureChange, ContrastIgnoresPixelsNearWhite) {
  // A brighter lamp reduces the contrast of bright areas and increases that of others.
  cv::Mat before = grey(120, 12), after;
  before(cv::Rect(40, 0, 120, 120)) += 90;
  after = cv::min(before * 1.25, kWhite);
  const double gain = 1 / 1.25;
  EXPECT_NEAR(texture_change(before, after * gain, kWhite * gain).contrast, 1, 0.05)
      << "made as bright, what is not clipped has its contrast back";
  EXPECT_NEAR(texture_change(before, after, kWhite).contrast, gain, 0.05);
}

TEST(TextureChange, ContrastIgnoresPixelsClippedInTheImageAfter) {
  // Clipped in the image after and then darkened, so that it no longer appears white.
  const cv::Mat before = grey(170, 15);
  const cv::Mat clipped = cv::min(before * 1.4, kWhite) / 1.4;
  EXPECT_DOUBLE_EQ(texture_change(before, clipped, kWhite / 1.4).contrast, 1) << "nothing is told";
}

TEST(TextureChange, ContrastIsNotEstimatedFromFewSquares) {
  cv::Mat before(kSize, CV_32FC1, cv::Scalar(120)), after = before.clone();
  const cv::Rect patch(60, 40, 24, 24);
  grey(120, 15)(patch).copyTo(before(patch));
  cv::Mat(grey(120, 15)(patch) * 0.5 + 60).copyTo(after(patch));
  EXPECT_DOUBLE_EQ(texture_change(before, after, kWhite).contrast, 1);
}

TEST(TextureChange, MovedTextureIsDisplaced) {
  EXPECT_GT(texture_change(grey(120, 15, 1), grey(120, 15, 2), kWhite).displaced, 0.7);
}

TEST(TextureChange, MovedTextureUnderNoiseIsDisplaced) {
  EXPECT_GT(texture_change(noisy(grey(120, 15, 1), 8, 3), noisy(grey(120, 15, 2), 8, 4), kWhite)
                .displaced,
            0.7);
}

TEST(TextureChange, NoiseIsNotDisplacedTexture) {
  const cv::Mat plain(kSize, CV_32FC1, cv::Scalar(120));
  EXPECT_LT(texture_change(noisy(plain, 5, 3), noisy(plain, 5, 4), kWhite).displaced, 0.1);
}

TEST(TextureChange, FaultyPixelsAreNotDisplacedTexture) {
  const cv::Mat plain(kSize, CV_32FC1, cv::Scalar(120));
  cv::Mat before = plain.clone(), after = plain.clone();
  cv::RNG random(1);
  for (int i = 0; i < 200; ++i) {
    before.at<float>(random.uniform(0, kSize.height), random.uniform(0, kSize.width)) = 255;
    after.at<float>(random.uniform(0, kSize.height), random.uniform(0, kSize.width)) = 0;
  }
  EXPECT_LT(texture_change(before, after, kWhite).displaced, 0.1);
}

TEST(TextureChange, TextureInOnlyOneImageIsNotDisplaced) {
  // If an object is removed from a plain table, its texture disappears with it.
  cv::Mat after(kSize, CV_32FC1, cv::Scalar(120));
  grey(120, 15)(cv::Rect(0, 90, 160, 30)).copyTo(after(cv::Rect(0, 90, 160, 30)));
  EXPECT_LT(texture_change(grey(120, 15), after, kWhite).displaced, 0.2);
  EXPECT_LT(texture_change(after, grey(120, 15), kWhite).displaced, 0.2);
}

}  // namespace
}  // namespace mbncc::change
