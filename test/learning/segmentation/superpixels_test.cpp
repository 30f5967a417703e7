// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/superpixels.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "learning/images.hpp"
#include "mbncc/learning/sb_grabcut.hpp"

namespace mbncc {
namespace {

class AnySize : public testing::TestWithParam<std::tuple<std::string, cv::Size>> {};

TEST_P(AnySize, LabelsRunFromZeroToCount) {
  const auto& [method, size] = GetParam();
  const cv::Mat image = test::exposed(test::texture(size, cv::Scalar(100, 110, 120), 20, 1), 2);
  for (const int wanted : {1, 50, 100000}) {
    const Superpixels superpixels = superpixels_of(image, method, wanted);
    ASSERT_EQ(superpixels.labels.size(), image.size());
    double low = 0, high = 0;
    cv::minMaxLoc(superpixels.labels, &low, &high);
    EXPECT_GE(low, 0);
    EXPECT_LT(high, superpixels.count);
  }
}

INSTANTIATE_TEST_SUITE_P(Superpixels, AnySize,
                         testing::Combine(testing::Values("seeds", "slic"),
                                          testing::Values(cv::Size(8, 8), cv::Size(9, 31),
                                                          cv::Size(33, 17), cv::Size(400, 8),
                                                          cv::Size(70, 500), cv::Size(160, 121))));

TEST(Superpixels, RefuseImagesThatAreTooSmall) {
  for (const char* method : {"seeds", "slic"}) {
    EXPECT_THROW(superpixels_of(cv::Mat(7, 20, CV_8UC3), method, 10), std::invalid_argument);
    EXPECT_THROW(superpixels_of(cv::Mat(20, 20, CV_8UC1), method, 10), std::invalid_argument);
  }
}

TEST(Superpixels, RefuseAnUnknownMethod) {
  EXPECT_THROW(superpixels_of(cv::Mat(20, 20, CV_8UC3), "voronoi", 10), std::invalid_argument);
}

TEST(Superpixels, SimplifyingEvensOutTextureAndKeepsTheMean) {
  const cv::Mat image =
      test::exposed(test::texture({120, 90}, cv::Scalar(100, 110, 120), 20, 1, 1), 2);
  const cv::Mat simple = simplify_superpixels(image, seeds_superpixels(image, 100));
  cv::Scalar mean_before, deviation_before, mean_after, deviation_after;
  cv::meanStdDev(image, mean_before, deviation_before);
  cv::meanStdDev(simple, mean_after, deviation_after);
  EXPECT_LT(deviation_after[0], deviation_before[0]);
  EXPECT_NEAR(mean_after[0], mean_before[0], 1);
}

TEST(Superpixels, TheMajorityDecidesWhatIsInside) {
  Superpixels halves;
  halves.labels = cv::Mat::zeros(10, 20, CV_32SC1);
  halves.labels.colRange(10, 20).setTo(1);
  halves.count = 2;
  cv::Mat region = cv::Mat::zeros(10, 20, CV_8UC1);
  region.colRange(4, 14).setTo(255);
  const cv::Mat inside = superpixels_inside(halves, region);
  EXPECT_EQ(cv::countNonZero(inside.colRange(0, 10)), 100);
  EXPECT_EQ(cv::countNonZero(inside.colRange(10, 20)), 0);
}

TEST(Grabcut, AcceptsMasksWithoutOneSide) {
  const cv::Mat image = test::exposed(test::texture({40, 40}, cv::Scalar(100, 110, 120), 20, 1), 2);
  const cv::Mat background(40, 40, CV_8UC1, cv::Scalar(cv::GC_BGD));
  const cv::Mat foreground(40, 40, CV_8UC1, cv::Scalar(cv::GC_PR_FGD));
  EXPECT_EQ(cv::countNonZero(repeatable_grabcut(image, background, 2)), 0);
  EXPECT_EQ(cv::countNonZero(repeatable_grabcut(image, foreground, 2)), 1600);
}

TEST(Grabcut, DoesNotChangeTheRandomState) {
  const test::DrawnLesson drawn = test::draw_lesson();
  cv::setRNGSeed(42);
  const std::uint64_t state = cv::theRNG().state;
  grabcut_rect(drawn.lesson.before, drawn.lesson.region, 1);
  EXPECT_EQ(cv::theRNG().state, state);
}

}  // namespace
}  // namespace mbncc
