// SPDX-License-Identifier: BSD-3-Clause
#include "matching/proposal/colour_prefilter.hpp"

#include <gtest/gtest.h>

#include "imaging/pyramid.hpp"
#include "matching/images.hpp"
#include "matching/template/map_geometry.hpp"

namespace mbncc::proposal {
namespace {

/// A texture with another mean colour, shifted by `tint` (b, g, r) [grey levels].
cv::Mat tinted(cv::Size size, std::uint64_t seed, const cv::Scalar& tint) {
  return test::texture(size, seed, 4) + tint;
}

class ColourPrefilterTest : public ::testing::Test {
 protected:
  const cv::Size size_{320, 240};
  const cv::Point2d anchor_{60, 60};
  test::LearningImage source_{1};

  ColourPrefilterTest() { source_.surface = tinted(source_.map.size(), 1, {-60, 0, 60}); }

  ColourPrefilter prefilter() const {
    return {source_.surface, source_.map, anchor_,
            templates::MapGeometry(source_.map).mean_width()};
  }

  static imaging::ClassImages classes_of(const cv::Mat& scene) {
    return imaging::ClassImages(imaging::build_pyramid(scene, imaging::ClassImages::kLast));
  }

  static double part_of(const SearchMask& places, cv::Size size) {
    return cv::countNonZero(places.of_positions(0, {0, 0}, 1, size)) /
           static_cast<double>(size.area());
  }
};

TEST_F(ColourPrefilterTest, KeepsTheTruePlaceAndLittleElseAtAnyRotation) {
  for (int k = 0; k < 8; ++k) {
    cv::Mat scene = tinted(size_, 10 + static_cast<unsigned>(k), {20, 0, -20});
    const Pose2D truth{110.0 + 10 * k, 100.0 + 5 * k, 0.8 * k};
    test::place(scene, source_, anchor_, truth);
    const SearchMask places = prefilter().places(classes_of(scene));
    EXPECT_FALSE(places.everywhere());
    const cv::Mat wanted = places.of_positions(0, {0, 0}, 1, size_);
    EXPECT_NE(wanted.at<uchar>(cvRound(truth.y), cvRound(truth.x)), 0) << "rotation " << k;
    EXPECT_LT(part_of(places, size_), 0.35);
  }
}

TEST_F(ColourPrefilterTest, KeepsEverythingIfTheObjectsColoursAreEverywhere) {
  cv::Mat scene = tinted(size_, 11, {-60, 0, 60});
  test::place(scene, source_, anchor_, {150, 120, 1});
  EXPECT_TRUE(prefilter().places(classes_of(scene)).everywhere());
}

TEST_F(ColourPrefilterTest, AlwaysKeepsSomething) {
  const cv::Mat scene = tinted(size_, 12, {60, 0, -60});
  EXPECT_GT(part_of(prefilter().places(classes_of(scene)), size_), 0.02);
}

TEST_F(ColourPrefilterTest, DoesNotFilterSmallImages) {
  const cv::Mat scene = tinted({16, 16}, 13, {60, 0, -60});
  EXPECT_TRUE(
      prefilter().places(imaging::ClassImages(imaging::build_pyramid(scene, 0))).everywhere());
}

TEST(SearchMask, MapsPositionsOfEveryLevelToTheirCells) {
  cv::Mat mask = cv::Mat::zeros(3, 4, CV_8UC1);
  mask.at<uchar>(1, 2) = 255;
  const SearchMask places(mask, 3);  // cells of 8 px: x 16..23, y 8..15
  for (int level = 0; level <= 3; ++level) {
    const cv::Mat wanted = places.of_positions(level, {0, 0}, 1, {32 >> level, 24 >> level});
    EXPECT_EQ(cv::countNonZero(wanted), (8 >> level) * (8 >> level)) << "level " << level;
    EXPECT_NE(wanted.at<uchar>(8 >> level, 16 >> level), 0);
  }
  const cv::Mat stepped = places.of_positions(0, {4, 2}, 2, {10, 10});
  EXPECT_EQ(cv::countNonZero(stepped), 4 * 4);
  EXPECT_NE(stepped.at<uchar>(3, 6), 0);
}

}  // namespace
}  // namespace mbncc::proposal
