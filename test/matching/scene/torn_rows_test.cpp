// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scene/torn_rows.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "matching/images.hpp"

namespace mbncc::scene {
namespace {

using test::torn;

const cv::Size kSize(320, 240);
const cv::Rect kBox(140, 90, 60, 50);

cv::Mat textured() {
  return test::texture(kSize, 77, 5);
}

/// A plain bright object, slightly larger than kBox, on a plain platform with noise.
cv::Mat plain() {
  cv::Mat image(kSize, CV_8UC1, cv::Scalar(90)), noise(kSize, CV_16SC1);
  cv::rectangle(image, kBox, cv::Scalar(200), cv::FILLED);
  cv::GaussianBlur(image, image, {}, 0.8);
  cv::RNG(5).fill(noise, cv::RNG::NORMAL, 0, 3);
  cv::add(image, noise, image, {}, CV_8U);
  return image;
}

cv::Mat grey(const cv::Mat& image) {
  cv::Mat result = image;
  if (image.channels() == 3) cv::cvtColor(image, result, cv::COLOR_BGR2GRAY);
  return result;
}

TEST(TornRows, AnIntactImageHasNone) {
  EXPECT_FALSE(has_torn_rows(grey(textured()), kBox));
  EXPECT_FALSE(has_torn_rows(plain(), kBox));
}

TEST(TornRows, AreDetectedAtEveryRowOfTheObject) {
  for (const int from : {105, 115, 125})
    for (const double way : {-12., -8., -4., 4., 8., 12.}) {
      EXPECT_TRUE(has_torn_rows(grey(torn(textured(), from, way)), kBox)) << from << ' ' << way;
      EXPECT_TRUE(has_torn_rows(torn(plain(), from, way), kBox)) << from << ' ' << way;
    }
}

TEST(TornRows, DoNotAffectAnObjectElsewhere) {
  for (const int from : {60, 180})
    EXPECT_FALSE(has_torn_rows(grey(torn(textured(), from, 8)), kBox)) << from;
}

TEST(TornRows, AnEdgeAlongTheRowsIsNoTear) {
  cv::Mat image = plain();
  image.rowRange(115, kSize.height) += cv::Scalar(40);
  EXPECT_FALSE(has_torn_rows(image, kBox));
}

// A row is displaced only if it differs more than the rows beside it.
TEST(TornRows, ADisplacedRowBesideAnEdgeIsNoTear) {
  cv::Mat image = torn(grey(textured()), 115, 8);
  image.rowRange(116, kSize.height) += cv::Scalar(60);
  EXPECT_FALSE(has_torn_rows(image, kBox));
}

/// Slanted lines are displaced in every row.
TEST(TornRows, FlatLinesAreNoTear) {
  cv::Mat image(kSize, CV_8UC1, cv::Scalar(90));
  for (int y = -200; y < kSize.height; y += 15)
    cv::line(image, {0, y}, {kSize.width, y + 60}, cv::Scalar(200), 2, cv::LINE_AA);
  EXPECT_FALSE(has_torn_rows(image, kBox));
}

TEST(TornRows, ACheckeredPlatformIsNoTear) {
  for (const int side : {6, 10, 14}) {
    cv::Mat image(kSize, CV_8UC1);
    for (int y = 0; y < image.rows; ++y)
      for (int x = 0; x < image.cols; ++x)
        image.at<uchar>(y, x) = (x / side + y / side) % 2 == 0 ? 90 : 200;
    cv::GaussianBlur(image, image, {}, 0.8);
    EXPECT_FALSE(has_torn_rows(image, kBox)) << side;
  }
}

TEST(TornRows, AreDetectedForAnObjectAtTheImageBorder) {
  const cv::Mat image = grey(torn(textured(), 115, 8));
  for (const int x : {-40, 300}) EXPECT_TRUE(has_torn_rows(image, {x, 90, 60, 50})) << x;
  EXPECT_FALSE(has_torn_rows(image, {-400, -400, 60, 50}));
  EXPECT_FALSE(has_torn_rows(image, {140, 115, 1, 1}));
}

}  // namespace
}  // namespace mbncc::scene
