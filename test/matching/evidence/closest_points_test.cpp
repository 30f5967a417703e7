// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/closest_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "matching/images.hpp"

namespace mbncc::evidence {
namespace {

templates::ContourTemplate contour_of(const cv::Mat& map, cv::Point2d anchor) {
  const templates::MapGeometry geometry(map);
  return {templates::ContourTemplate::edge_of(geometry, 0), anchor, 0, 200};
}

cv::Mat angle_with_leg(int length) {
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
  map(cv::Rect(20, 20, 16, 80)) = 255;
  map(cv::Rect(20, 84, length, 16)) = 255;
  return map;
}

void expect_near(const Pose2D& pose, const Pose2D& wanted, double distance) {
  EXPECT_NEAR(pose.x, wanted.x, distance);
  EXPECT_NEAR(pose.y, wanted.y, distance);
  EXPECT_NEAR(angle_distance(pose.theta, wanted.theta), 0, distance / 40);
}

TEST(ClosestPoints, AlignsAContourWithItselfFromAWrongPose) {
  const auto contour = contour_of(angle_with_leg(60), {50, 65});
  const ClosestPoints closest(contour);
  for (const Pose2D& start : {Pose2D{0, 0, 0}, Pose2D{9, -6, 0.2}, Pose2D{-5, 8, -0.25}}) {
    const RegisteredContour laid = closest.align(contour, start);
    expect_near(laid.pose, {0, 0, 0}, 0.1);
    EXPECT_GT(laid.covered, 0.95);
  }
}

TEST(ClosestPoints, AnotherReferencePointShiftsThePose) {
  const auto fixed = contour_of(angle_with_leg(60), {50, 65});
  const RegisteredContour laid =
      ClosestPoints(fixed).align(contour_of(angle_with_leg(60), {62, 56}), {0, 0, 0.1});
  expect_near(laid.pose, {12, -9, 0}, 0.2);
}

TEST(ClosestPoints, MissingPartsDoNotBiasThePose) {
  const auto fixed = contour_of(angle_with_leg(60), {50, 65});
  const RegisteredContour laid =
      ClosestPoints(fixed).align(contour_of(angle_with_leg(30), {50, 65}), {3, -4, 0.1});
  expect_near(laid.pose, {0, 0, 0}, 0.3);
  EXPECT_LT(laid.covered, 0.97);
}

TEST(ClosestPoints, MapsOfAnyShapeAndSizeAreAligned) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(100, 1), cv::Size(1, 100),
                              cv::Size(16384, 1), cv::Size(3000, 3000)}) {
    cv::Mat map = cv::Mat::zeros(size + cv::Size(4, 4), CV_8UC1);
    map(cv::Rect({2, 2}, size)) = 255;
    const auto fixed = contour_of(map, {2 + size.width / 2., 2 + size.height / 2.});
    const RegisteredContour aligned = ClosestPoints(fixed).align(fixed, {0, 0, 0});
    EXPECT_GE(aligned.covered, 0) << size;
    EXPECT_LE(aligned.covered, 1.0001) << size;
    EXPECT_TRUE(std::isfinite(aligned.pose.x + aligned.pose.y + aligned.pose.theta)) << size;
  }
}

TEST(ClosestPoints, DoesNotPairEdgesOfOppositeDirections) {
  // In a narrow leg beside another one, the edge nearest to each side is the opposite side of the
  // other leg.
  cv::Mat leg = cv::Mat::zeros(120, 120, CV_8UC1);
  leg(cv::Rect(20, 56, 80, 8)) = 255;
  const auto fixed = contour_of(leg, {60, 60});
  expect_near(ClosestPoints(fixed).align(fixed, {0, 7, 0}).pose, {0, 0, 0}, 0.2);
}

}  // namespace
}  // namespace mbncc::evidence
