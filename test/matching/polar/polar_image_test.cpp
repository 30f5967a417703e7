// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/polar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "matching/images.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc {
namespace {

cv::Mat grey_texture(cv::Size size, std::uint64_t seed) {
  cv::Mat grey;
  cv::cvtColor(test::texture(size, seed), grey, cv::COLOR_BGR2GRAY);
  return grey;
}

/// `image` rotated by `theta` from x towards y about `centre`.
cv::Mat turned(const cv::Mat& image, cv::Point2d centre, double theta) {
  const double c = std::cos(theta), s = std::sin(theta);
  const cv::Matx23d motion(c, -s, centre.x - c * centre.x + s * centre.y,  //
                           s, c, centre.y - s * centre.x - c * centre.y);
  cv::Mat result;
  cv::warpAffine(image, result, motion, image.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
  return result;
}

class PolarTest : public ::testing::Test {
 protected:
  const cv::Mat image_ = grey_texture({121, 121}, 3);
  const cv::Point2d centre_{60, 60};
  const PolarGrid grid_ = PolarGrid::of(36);
  const cv::Mat map_ = [] {
    cv::Mat map = cv::Mat::zeros(121, 121, CV_8UC1);
    map(cv::Rect(40, 45, 40, 25)) = 255;
    return map;
  }();
};

TEST_F(PolarTest, AWholeTurnHasStepsOfAtMostAPixel) {
  EXPECT_GE(grid_.angles, 2 * kPi * grid_.radius);
  EXPECT_EQ(grid_.angles % 16, 0);
  EXPECT_GE(grid_.rings, grid_.radius);
}

TEST_F(PolarTest, TurningTheSceneShiftsTheColumns) {
  const PolarImage still = polar_image(image_, centre_, grid_);
  for (const int shift : {1, 17, grid_.angles / 2, grid_.angles - 5}) {
    const double theta = 2 * kPi * shift / grid_.angles;
    const PolarImage moved = polar_image(turned(image_, centre_, theta), centre_, grid_);
    double difference = 0;
    for (int ring = 0; ring < grid_.rings; ++ring)
      for (int j = 0; j < grid_.angles; ++j)
        difference += std::abs(moved.values.at<float>(ring, (j + shift) % grid_.angles) -
                               still.values.at<float>(ring, j));
    EXPECT_LT(difference / (grid_.rings * grid_.angles), 1.5) << "shift " << shift;
  }
}

TEST_F(PolarTest, TheSimilarityPeaksAtTheRotation) {
  const PolarTemplate object(image_, map_, centre_, grid_);
  for (const int shift : {0, 3, 100, grid_.angles - 1}) {
    const cv::Mat scene = turned(image_, centre_, 2 * kPi * shift / grid_.angles);
    const auto values = object.similarities(polar_image(scene, centre_, grid_));
    const auto best = std::max_element(values.begin(), values.end());
    EXPECT_EQ(best - values.begin(), shift);
    EXPECT_GT(*best, 0.9);
  }
}

TEST_F(PolarTest, ARangeOfShiftsGivesTheSameValues) {
  const PolarTemplate object(image_, map_, centre_, grid_);
  const PolarImage target = polar_image(grey_texture({121, 121}, 4), centre_, grid_);
  const auto all = object.similarities(target);
  const auto some = object.similarities(target, -3, 7);
  for (int k = 0; k < 7; ++k) EXPECT_EQ(some[k], all[(k - 3 + grid_.angles) % grid_.angles]);
}

TEST_F(PolarTest, PixelsOutsideTheMapHaveNoInfluence) {
  cv::Mat other = grey_texture(image_.size(), 5);
  image_.copyTo(other, map_);
  const PolarImage target = polar_image(grey_texture({121, 121}, 6), centre_, grid_);
  EXPECT_EQ(PolarTemplate(image_, map_, centre_, grid_).similarities(target),
            PolarTemplate(other, map_, centre_, grid_).similarities(target));
}

TEST_F(PolarTest, GainAndOffsetHardlyMatter) {
  const PolarTemplate object(image_, map_, centre_, grid_);
  cv::Mat brighter;
  image_.convertTo(brighter, CV_8U, 0.8, 30);
  const auto plain = object.similarities(polar_image(image_, centre_, grid_));
  const auto changed = object.similarities(polar_image(brighter, centre_, grid_));
  for (std::size_t k = 0; k < plain.size(); ++k) EXPECT_NEAR(plain[k], changed[k], 0.03);
}

TEST_F(PolarTest, FlatImagesAndEmptyRegionsGiveZero) {
  const PolarImage flat = polar_image(cv::Mat(121, 121, CV_8UC1, cv::Scalar(90)), centre_, grid_);
  for (double value : PolarTemplate(image_, map_, centre_, grid_).similarities(flat))
    EXPECT_NEAR(value, 0, 1e-3);
  const cv::Mat nothing = cv::Mat::zeros(image_.size(), CV_8UC1);
  for (double value : PolarTemplate(image_, nothing, centre_, grid_).similarities(flat))
    EXPECT_EQ(value, 0);
}

TEST_F(PolarTest, RefusesImagesThatDoNotFit) {
  EXPECT_THROW(polar_image(cv::Mat::zeros(9, 9, CV_8UC3), {4, 4}, grid_), std::invalid_argument);
  EXPECT_THROW(PolarTemplate(image_, cv::Mat::zeros(9, 9, CV_8UC1), centre_, grid_),
               std::invalid_argument);
  const PolarTemplate object(image_, map_, centre_, grid_);
  EXPECT_THROW(object.similarities(polar_image(image_, centre_, PolarGrid::of(20))),
               std::invalid_argument);
}

}  // namespace
}  // namespace mbncc
