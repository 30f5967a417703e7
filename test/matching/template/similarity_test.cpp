// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/similarity.hpp"

#include <gtest/gtest.h>

#include "matching/images.hpp"

namespace mbncc {
namespace {

class SimilarityTest : public ::testing::Test {
 protected:
  static cv::Mat grey(const cv::Mat& colour) {
    cv::Mat image;
    cv::cvtColor(colour, image, cv::COLOR_BGR2GRAY);
    return image;
  }

  const test::LearningImage source_{11};
  const cv::Mat learned_ = grey(source_.image);
  const cv::Point2d anchor_{60, 60};
  const MaskedTemplate points_ = masked_template(learned_, source_.map, anchor_);
  const Pose2D home_{60, 60, 0};
};

TEST_F(SimilarityTest, IsOneAtTheLearnedPose) {
  const Similarity similar = similarity(points_, learned_, home_, 0);
  EXPECT_NEAR(similar.value, 1, 1e-9);
  EXPECT_EQ(similar.visible, 1);
}

TEST_F(SimilarityTest, PixelsOutsideTheMapHaveNoInfluence) {
  cv::Mat other = grey(test::texture(learned_.size(), 12));
  learned_.copyTo(other, source_.map);
  const cv::Mat scene = grey(test::texture(learned_.size(), 13));
  EXPECT_EQ(
      similarity(points_, scene, {60.3, 59.1, 0.4}).value,
      similarity(masked_template(other, source_.map, anchor_), scene, {60.3, 59.1, 0.4}).value);
  EXPECT_EQ(similarity(points_, learned_, home_).value, similarity(points_, other, home_).value);
}

TEST_F(SimilarityTest, GainAndOffsetDoNotMatter) {
  MaskedTemplate stretched = points_;
  for (auto& value : stretched.values) value = 0.5f * value + 31;
  const Pose2D pose{61.2, 58.7, 0.05};
  EXPECT_NEAR(similarity(points_, learned_, pose, 0).value,
              similarity(stretched, learned_, pose, 0).value, 1e-6);
}

TEST_F(SimilarityTest, IsMinusOneOnTheNegative) {
  EXPECT_NEAR(similarity(points_, 255 - learned_, home_, 0).value, -1, 1e-9);
}

TEST_F(SimilarityTest, FlatPlacesGiveZero) {
  const cv::Mat flat(learned_.size(), CV_8UC1, cv::Scalar(80));
  EXPECT_EQ(similarity(points_, flat, home_).value, 0);
  EXPECT_EQ(similarity(points_, flat, home_, 0).value, 0);
}

TEST_F(SimilarityTest, PointsBeyondTheBorderDoNotCount) {
  const cv::Rect cut(0, 0, 120, 70);  // the map reaches from row 25 to row 95
  const Similarity similar = similarity(points_, learned_(cut), home_, 0);
  EXPECT_NEAR(similar.value, 1, 1e-9);
  EXPECT_LT(similar.visible, 0.7);
  EXPECT_EQ(similarity(points_, learned_, {-200, 60, 0}).visible, 0);
}

TEST_F(SimilarityTest, CoarserLevelsKeepTheMapsWeight) {
  const MaskedTemplate coarse = masked_template(learned_, source_.map, anchor_, 2);
  EXPECT_NEAR(static_cast<double>(coarse.size()) * 16, static_cast<double>(points_.size()), 400);
}

TEST_F(SimilarityTest, RefusesImagesThatDoNotFit) {
  EXPECT_THROW(masked_template(learned_, cv::Mat::zeros(5, 5, CV_8UC1), anchor_),
               std::invalid_argument);
  EXPECT_THROW(masked_template(source_.image, source_.map, anchor_), std::invalid_argument);
}

}  // namespace
}  // namespace mbncc
