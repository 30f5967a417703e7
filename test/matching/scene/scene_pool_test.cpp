// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scene/scene_pool.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <opencv2/core.hpp>
#include <stdexcept>

namespace mbncc::scene {
namespace {

constexpr int kTop = 2;

cv::Mat random_image(cv::Size size, int type, std::uint64_t seed) {
  cv::Mat image(size, type);
  cv::RNG(seed).fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

bool equal(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

/// Expects the same data in `scene` as in a new scene.
void expect_as_if_fresh(const SceneImage& scene, const cv::Mat& image) {
  constexpr int kMargin = 20;
  const SceneImage fresh(image, kTop);
  ASSERT_EQ(scene.levels.size(), fresh.levels.size());
  for (std::size_t level = 0; level < fresh.levels.size(); ++level) {
    const auto maps = scene.levels[level].responses(kMargin);
    const auto expected = fresh.levels[level].responses(kMargin);
    EXPECT_TRUE(equal(scene.grey[level], fresh.grey[level]));
    EXPECT_TRUE(equal(scene.levels[level].whole().colour, fresh.levels[level].whole().colour));
    EXPECT_TRUE(equal(scene.levels[level].whole().edges, fresh.levels[level].whole().edges));
    const cv::Size size = scene.grey[level].size();
    for (int k = 0; k < ResponseMaps::kOrientations; ++k)
      for (int y = -kMargin; y < size.height + kMargin; ++y)
        for (int x = -kMargin; x < size.width + kMargin; ++x)
          ASSERT_EQ(maps->data()[maps->offset(k, x, y)],
                    expected->data()[expected->offset(k, x, y)]);
    const auto padded = scene.padded(static_cast<int>(level), kMargin);
    const auto expected_padded = fresh.padded(static_cast<int>(level), kMargin);
    ASSERT_EQ(padded->margin(), expected_padded->margin());
    EXPECT_EQ(padded->squares, expected_padded->squares);
  }
}

TEST(ScenePool, ReusedScenesEqualFreshOnes) {
  ScenePool pool;
  std::uint64_t seed = 1;
  for (const cv::Size size :
       {cv::Size(97, 64), cv::Size(97, 64), cv::Size(64, 97), cv::Size(40, 30)})
    for (const int type : {CV_8UC3, CV_8UC1, CV_8UC3}) {
      const cv::Mat image = random_image(size, type, seed++);
      expect_as_if_fresh(*pool.prepare(image, kTop), image);
    }
}

TEST(ScenePool, ALargerMarginKeepsTheNarrowerOneValid) {
  const SceneImage scene(random_image({60, 50}, CV_8UC3, 3), 0);
  const auto narrow = scene.levels[0].responses(10);
  const std::int8_t before = narrow->data()[narrow->offset(2, 30, 20)];
  const auto wide = scene.levels[0].responses(50);
  EXPECT_GE(wide->margin(), 50);
  EXPECT_EQ(wide->data()[wide->offset(2, 30, 20)], before);
  EXPECT_EQ(narrow->data()[narrow->offset(2, 30, 20)], before) << "who has it may go on reading";
  EXPECT_EQ(scene.levels[0].responses(10), wide);
}

TEST(ScenePool, DoesNotChangeTheCallersImages) {
  ScenePool pool;
  const cv::Mat grey = random_image({50, 40}, CV_8UC1, 1), kept = grey.clone();
  pool.prepare(grey, kTop);
  pool.prepare(random_image({50, 40}, CV_8UC3, 2), kTop);
  EXPECT_TRUE(equal(grey, kept));
}

TEST(ScenePool, SimultaneousImagesAreIndependent) {
  ScenePool pool;
  const cv::Mat first = random_image({50, 40}, CV_8UC3, 1);
  const cv::Mat second = random_image({50, 40}, CV_8UC3, 2);
  const auto one = pool.prepare(first, kTop), other = pool.prepare(second, kTop);
  expect_as_if_fresh(*one, first);
  expect_as_if_fresh(*other, second);
}

TEST(ScenePool, RecoversFromUnusableImages) {
  ScenePool pool;
  EXPECT_THROW(pool.prepare(cv::Mat(40, 40, CV_16UC1), kTop), std::invalid_argument);
  const cv::Mat image = random_image({50, 40}, CV_8UC3, 1);
  expect_as_if_fresh(*pool.prepare(image, kTop), image);
}

}  // namespace
}  // namespace mbncc::scene
