// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace mbncc::test {
namespace {

class RandomPoses {
 public:
  Pose2D pose() { return {place_(random_), place_(random_), angle_(random_)}; }
  cv::Point2d point() { return {place_(random_), place_(random_)}; }

 private:
  std::mt19937 random_{3};
  std::uniform_real_distribution<double> place_{-500, 500};
  std::uniform_real_distribution<double> angle_{-kPi, kPi};
};

void expect_near(cv::Point2d a, cv::Point2d b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
}

TEST(Angles, AreWrappedIntoMinusPiToPi) {
  EXPECT_DOUBLE_EQ(wrap_angle(0), 0);
  EXPECT_DOUBLE_EQ(wrap_angle(kPi), kPi);
  EXPECT_DOUBLE_EQ(wrap_angle(-kPi), kPi);
  for (int i = -40; i <= 40; ++i) {
    const double angle = 0.37 * i, wrapped = wrap_angle(angle);
    EXPECT_GT(wrapped, -kPi);
    EXPECT_LE(wrapped, kPi);
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-12);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-12);
  }
}

TEST(Angles, DistanceRespectsSymmetry) {
  EXPECT_NEAR(angle_distance(to_radians(170), to_radians(-170)), to_radians(20), 1e-12);
  EXPECT_NEAR(angle_distance(to_radians(10), to_radians(190), 2), 0, 1e-12);
  EXPECT_NEAR(angle_distance(to_radians(10), to_radians(140), 3), to_radians(10), 1e-12);
  EXPECT_EQ(angle_distance(1, 2, 0), 0);
}

TEST(Rotation, PositiveThetaTurnsXTowardsY) {
  expect_near(rotate({1, 0}, kPi / 2), {0, 1});
  expect_near(transform({10, 20, kPi / 2}, {3, 0}), {10, 23});
}

TEST(Poses, ComposeAppliesOneTransformAfterTheOther) {
  RandomPoses random;
  for (int i = 0; i < 100; ++i) {
    const Pose2D outer = random.pose(), inner = random.pose();
    const cv::Point2d point = random.point();
    expect_near(transform(compose(outer, inner), point), transform(outer, transform(inner, point)));
  }
}

TEST(Poses, InverseUndoesTheTransform) {
  RandomPoses random;
  for (int i = 0; i < 100; ++i) {
    const Pose2D pose = random.pose();
    const cv::Point2d point = random.point();
    expect_near(transform(inverse(pose), transform(pose, point)), point);
    EXPECT_EQ(Transform(pose)(point), transform(pose, point));
  }
}

TEST(Maps, CentroidIsTheMeanOfThePixels) {
  cv::Mat map = cv::Mat::zeros(10, 10, CV_8UC1);
  map(cv::Rect(2, 3, 3, 5)).setTo(255);
  expect_near(centroid(map), {3, 5});
}

TEST(Maps, ExcircleHoldsEveryPixelAndTouchesSome) {
  cv::RNG random(5);
  for (int round = 0; round < 20; ++round) {
    cv::Mat map = cv::Mat::zeros(60, 80, CV_8UC1);
    for (int i = 0; i < 12; ++i)
      map.at<std::uint8_t>(random.uniform(0, 60), random.uniform(0, 80)) = 255;
    const Circle circle = excircle(map);
    double farthest = 0;
    for (int y = 0; y < map.rows; ++y)
      for (int x = 0; x < map.cols; ++x)
        if (map.at<std::uint8_t>(y, x) != 0)
          farthest = std::max(farthest, cv::norm(cv::Point2d(x, y) - circle.centre));
    EXPECT_NEAR(farthest, circle.radius, 0.01);
  }
}

TEST(Maps, IncircleHoldsMapPixelsOnly) {
  cv::Mat map = cv::Mat::zeros(60, 80, CV_8UC1);
  map(cv::Rect(10, 10, 21, 41)).setTo(255);
  const Circle circle = incircle(map);
  EXPECT_NEAR(circle.radius, 10.5, 0.01);
  EXPECT_NEAR(circle.centre.x, 20, 0.01);
  cv::Mat full(20, 20, CV_8UC1, cv::Scalar(255));
  EXPECT_LE(incircle(full).radius, 10) << "what lies beyond the image is no map";
}

TEST(Maps, EmptyMapsAreRefused) {
  const cv::Mat empty = cv::Mat::zeros(5, 5, CV_8UC1);
  EXPECT_THROW(centroid(empty), std::invalid_argument);
  EXPECT_THROW(excircle(empty), std::invalid_argument);
  EXPECT_THROW(incircle(empty), std::invalid_argument);
  EXPECT_THROW(centroid(cv::Mat()), std::invalid_argument);
}

TEST(Maps, BinaryMeansZeroAnd255InOneChannel) {
  EXPECT_TRUE(is_binary_map(cv::Mat::zeros(5, 5, CV_8UC1)));
  EXPECT_FALSE(is_binary_map(cv::Mat()));
  EXPECT_FALSE(is_binary_map(cv::Mat::zeros(5, 5, CV_8UC3)));
  EXPECT_FALSE(is_binary_map(cv::Mat(5, 5, CV_8UC1, cv::Scalar(254))));
}

}  // namespace
}  // namespace mbncc::test
