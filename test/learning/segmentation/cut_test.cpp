// SPDX-License-Identifier: BSD-3-Clause
// Colour mixture, arrival test, graph cut and clean-up.
#include <gtest/gtest.h>

#include "learning/change/arrivals.hpp"
#include "learning/change/changed_places.hpp"
#include "learning/change/colour_mixture.hpp"
#include "learning/change/departures.hpp"
#include "learning/images.hpp"
#include "learning/segmentation/clean_map.hpp"
#include "learning/segmentation/graph_cut.hpp"
#include "learning/segmentation/half_smoothness.hpp"

namespace mbncc {
namespace {

segmentation::Smoothness random_smoothness(cv::Size size, cv::RNG& random) {
  segmentation::Smoothness smoothness;
  smoothness.strength = 3;
  for (std::size_t k = 0; k < smoothness.weights.size(); ++k) {
    const int dx = segmentation::Smoothness::kDx[k], dy = segmentation::Smoothness::kDy[k];
    smoothness.weights[k] = cv::Mat::zeros(size, CV_32FC1);
    for (int y = -dy; y < size.height; ++y)
      for (int x = std::max(0, -dx); x < size.width - std::max(0, dx); ++x)
        smoothness.weights[k].at<float>(y, x) = random.uniform(0.F, 3.F);
  }
  return smoothness;
}

double energy(const cv::Mat& map, const cv::Mat& unary,
              const segmentation::Smoothness& smoothness) {
  double sum = 0;
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) {
      if (map.at<uchar>(y, x)) sum -= unary.at<float>(y, x);
      for (std::size_t k = 0; k < smoothness.weights.size(); ++k) {
        const float weight = smoothness.weights[k].at<float>(y, x);
        if (weight > 0 &&
            map.at<uchar>(y, x) != map.at<uchar>(y + segmentation::Smoothness::kDy[k],
                                                 x + segmentation::Smoothness::kDx[k]))
          sum += weight;
      }
    }
  return sum;
}

// The reference result: tries every map.
double least_energy(const cv::Mat& unary, const segmentation::Smoothness& smoothness) {
  const int pixels = static_cast<int>(unary.total());
  double least = 1e9;
  cv::Mat map(unary.size(), CV_8UC1);
  for (int code = 0; code < 1 << pixels; ++code) {
    for (int i = 0; i < pixels; ++i) map.data[i] = code >> i & 1 ? 255 : 0;
    least = std::min(least, energy(map, unary, smoothness));
  }
  return least;
}

TEST(Smoothness, TheRimIsFreeAndTheRestUnchanged) {
  cv::RNG random(3);
  const cv::Size size(9, 8);
  const cv::Mat nothing = cv::Mat::zeros(size, CV_8UC1), even = cv::Mat::zeros(size, CV_32FC1);
  cv::Mat mask = nothing.clone(), apart = nothing.clone();
  mask(cv::Rect(2, 1, 4, 5)).setTo(255);
  apart(cv::Rect(7, 1, 2, 6)).setTo(255);
  const segmentation::Smoothness before = random_smoothness(size, random),
                                 after = segmentation::with_free_rim(before, mask);
  EXPECT_GT(energy(mask, even, before), 0);
  EXPECT_EQ(energy(mask, even, after), 0);
  EXPECT_EQ(energy(apart, even, after), energy(apart, even, before));
  EXPECT_EQ(energy(mask, even, segmentation::with_free_rim(before, nothing)),
            energy(mask, even, before));
}

TEST(GraphCut, FindsTheLeastEnergyOfAllMaps) {
  cv::RNG random(7);
  for (const cv::Size size : {cv::Size(4, 3), cv::Size(1, 5), cv::Size(5, 1), cv::Size(3, 4)})
    for (int trial = 0; trial < 20; ++trial) {
      cv::Mat unary(size, CV_32FC1);
      random.fill(unary, cv::RNG::NORMAL, 0, 4);
      const segmentation::Smoothness smoothness = random_smoothness(size, random);
      const cv::Mat map = segmentation::minimum_cut(unary, smoothness);
      EXPECT_NEAR(energy(map, unary, smoothness), least_energy(unary, smoothness), 1e-3);
    }
}

// A map made of 2 x 2 blocks has the same energy at both resolutions.
TEST(GraphCut, HalfResolutionKeepsTheEnergyOfBlocks) {
  cv::RNG random(8);
  for (const cv::Size size : {cv::Size(8, 6), cv::Size(7, 5)}) {
    cv::Mat unary(size, CV_32FC1), blocks((size.height + 1) / 2, (size.width + 1) / 2, CV_8UC1);
    random.fill(unary, cv::RNG::NORMAL, 0, 4);
    const segmentation::Smoothness smoothness = random_smoothness(size, random);
    for (int trial = 0; trial < 10; ++trial) {
      random.fill(blocks, cv::RNG::UNIFORM, 0, 2);
      blocks *= 255;
      cv::Mat map;
      cv::resize(blocks, map, blocks.size() * 2, 0, 0, cv::INTER_NEAREST);
      EXPECT_NEAR(energy(map(cv::Rect({0, 0}, size)).clone(), unary, smoothness),
                  energy(blocks, segmentation::half_resolution(unary),
                         segmentation::half_resolution(smoothness)),
                  1e-3);
    }
  }
}

TEST(GraphCut, RefiningACoarseCutComesCloseToTheLeastEnergy) {
  cv::RNG random(9);
  for (const cv::Size size : {cv::Size(40, 31), cv::Size(33, 40)}) {
    cv::Mat unary(size, CV_32FC1);
    random.fill(unary, cv::RNG::NORMAL, 0, 6);
    cv::GaussianBlur(unary, unary, {}, 2);
    const segmentation::Smoothness smoothness = random_smoothness(size, random);
    cv::Mat map = segmentation::coarse_cut(unary, segmentation::half_resolution(smoothness));
    const double coarse = energy(map, unary, smoothness);
    segmentation::refine_cut(unary, smoothness, map);
    const double refined = energy(map, unary, smoothness);
    const double least = energy(segmentation::minimum_cut(unary, smoothness), unary, smoothness);
    EXPECT_LE(refined, coarse + 1e-3);
    EXPECT_GE(refined, least - 1e-3);
    EXPECT_LE(refined - least, 0.1 * (coarse - least) + 1e-3);
  }
}

TEST(GraphCut, ATiltedCutIsTheCutOfTheTiltedPreferences) {
  cv::RNG random(10);
  for (const cv::Size size : {cv::Size(40, 30), cv::Size(31, 17)})
    for (const float tilt : {-2.F, 2.F}) {
      cv::Mat unary(size, CV_32FC1);
      random.fill(unary, cv::RNG::NORMAL, 0, 4);
      const segmentation::Smoothness smoothness = random_smoothness(size, random);
      const segmentation::Smoothness half = segmentation::half_resolution(smoothness);
      const cv::Mat tilted =
          segmentation::tilted_coarse_cut(segmentation::coarse_cut(unary, half), unary, tilt, half);
      EXPECT_NEAR(energy(tilted, unary + tilt, smoothness),
                  energy(segmentation::coarse_cut(unary + tilt, half), unary + tilt, smoothness),
                  1e-2);
    }
}

TEST(ColourMixture, GivesItsOwnColoursTheHighestDensity) {
  const cv::Size size(60, 60);
  cv::Mat image = test::texture(size, cv::Scalar(40, 60, 200), 5, 1);
  test::texture(size, cv::Scalar(200, 60, 40), 5, 2)(cv::Rect(0, 0, 30, 60))
      .copyTo(image(cv::Rect(0, 0, 30, 60)));
  const change::ColourMixture mixture =
      change::ColourMixture::fit(image, cv::Mat(size, CV_8UC1, cv::Scalar(255)));
  const float between = mixture.density({120, 60, 120});
  EXPECT_GT(mixture.density({40, 60, 200}), 100 * between);
  EXPECT_GT(mixture.density({200, 60, 40}), 100 * between);
}

TEST(ColourMixture, GivesImagesTheDensitiesOfTheirPixels) {
  const cv::Size size(40, 30);
  const cv::Mat image = test::texture(size, cv::Scalar(40, 60, 200), 30, 1);
  const change::ColourMixture mixture =
      change::ColourMixture::fit(image, cv::Mat(size, CV_8UC1, cv::Scalar(255)));
  const cv::Mat densities = mixture.densities(image);
  for (const cv::Point at : {cv::Point(0, 0), cv::Point(39, 29), cv::Point(17, 4)}) {
    const float density = mixture.density(image.at<cv::Vec3f>(at));
    EXPECT_NEAR(densities.at<float>(at), density, 1e-4 * density);
  }
}

TEST(ColourMixture, OfTooFewPixelsIsEmpty) {
  const cv::Mat image(10, 10, CV_32FC3, cv::Scalar(1, 2, 3));
  const change::ColourMixture mixture =
      change::ColourMixture::fit(image, cv::Mat::zeros(10, 10, CV_8UC1));
  EXPECT_TRUE(mixture.empty());
  EXPECT_EQ(mixture.density({1, 2, 3}), 0);
}

TEST(ArrivalTest, DistinguishesTheNewPlaceFromTheOldOne) {
  const cv::Size size(200, 120);
  const cv::Mat platform = test::texture(size, cv::Scalar(105, 115, 120), 12, 1);
  const cv::Rect left(30, 40, 40, 40), right(130, 40, 40, 40);
  cv::Mat before = platform.clone(), after = platform.clone(), changed;
  before(left).setTo(cv::Scalar(30, 40, 200));
  after(right).setTo(cv::Scalar(30, 40, 200));
  changed = cv::Mat::zeros(size, CV_8UC1);
  changed(left).setTo(255);
  changed(right).setTo(255);
  const change::ColourMixture colours = change::ColourMixture::fit(platform, ~changed);
  const cv::Mat arrivals = change::find_arrivals(before, after, changed, colours);
  EXPECT_EQ(cv::countNonZero(arrivals(right)), right.area());
  EXPECT_EQ(cv::countNonZero(arrivals), right.area());
}

TEST(ArrivalTest, DeparturesOutweighPossibleArrivals) {
  const cv::Size size(320, 200);
  const cv::Mat platform = test::texture(size, cv::Scalar(105, 115, 120), 16, 1, 1.2);
  const cv::Rect left(30, 40, 40, 40), right(130, 40, 40, 40), gripper(220, 0, 100, 60);
  cv::Mat before = platform.clone(), after = platform.clone();
  before(left).setTo(cv::Scalar(30, 40, 200));
  after(right).setTo(cv::Scalar(30, 40, 200));
  test::texture(gripper.size(), cv::Scalar(97, 107, 112), 14, 2, 2).copyTo(after(gripper));
  cv::Mat changed = cv::Mat::zeros(size, CV_8UC1);
  for (const cv::Rect& rect : {left, right, gripper}) changed(rect).setTo(255);
  const cv::Mat weights =
      change::departures(test::exposed(before, 3), test::exposed(after, 4), changed);
  EXPECT_EQ(cv::countNonZero(weights(right)), 0);
  EXPECT_EQ(cv::countNonZero(weights(gripper)), gripper.area());
  const std::vector<cv::Rect> places = change::changed_places(weights, false);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places.front(), cv::Rect(22, 32, 56, 56));
}

TEST(CleanMap, KeepsNearAndLargePiecesOnly) {
  cv::Mat map = cv::Mat::zeros(100, 100, CV_8UC1);
  const cv::Rect body(10, 10, 30, 30), near(42, 10, 8, 30), far(80, 80, 8, 8);
  for (const cv::Rect& rect : {body, near, far}) map(rect).setTo(255);
  segmentation::keep_main_groups(map, {});
  EXPECT_EQ(cv::countNonZero(map(body)), body.area());
  EXPECT_EQ(cv::countNonZero(map(near)), near.area()) << "a gap of two pixels does not part them";
  EXPECT_EQ(cv::countNonZero(map(far)), 0);
}

TEST(CleanMap, KeepsAMarkedSmallGroup) {
  cv::Mat map = cv::Mat::zeros(60, 60, CV_8UC1), wanted = map.clone();
  map(cv::Rect(5, 5, 30, 30)).setTo(255);
  map(cv::Rect(50, 50, 5, 5)).setTo(255);
  wanted.at<uchar>(52, 52) = 255;
  const cv::Mat all = map.clone();
  segmentation::keep_main_groups(map, {}, wanted);
  EXPECT_EQ(cv::norm(map, all, cv::NORM_INF), 0);
}

TEST(CleanMap, RemovesSpecksAndKeepsThinParts) {
  cv::Mat map = cv::Mat::zeros(30, 40, CV_8UC1);
  cv::line(map, {5, 5}, {14, 14}, cv::Scalar(255));
  const cv::Mat thin = map.clone();
  map(cv::Rect(25, 20, 3, 2)).setTo(255);
  segmentation::remove_specks(map, 8);
  EXPECT_EQ(cv::countNonZero(map != thin), 0);
}

TEST(CleanMap, FillsSpecksButNotHoles) {
  cv::Mat map = cv::Mat::zeros(100, 100, CV_8UC1);
  map(cv::Rect(10, 10, 60, 60)).setTo(255);
  const cv::Rect speck(20, 20, 3, 3), hole(40, 40, 12, 12), bay(10, 60, 5, 2);
  for (const cv::Rect& rect : {speck, hole, bay}) map(rect).setTo(0);
  segmentation::fill_holes(map, 12);
  EXPECT_EQ(cv::countNonZero(map(speck)), speck.area());
  EXPECT_EQ(cv::countNonZero(map(hole)), 0);
  EXPECT_EQ(cv::countNonZero(map(bay)), 0) << "open to the outside";
}

}  // namespace
}  // namespace mbncc
