// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/platform.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace mbncc {
namespace {

constexpr PinholeCamera kCamera{600, 610, 319.5, 239.5};

Platform straight_down(double distance = 0.8) {
  return {rays_of(kCamera), plane_at(distance)};
}

cv::Matx33d rotation_x(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {1, 0, 0, 0, c, -s, 0, s, c};
}

cv::Matx44d pose_of(const cv::Matx33d& r, const cv::Vec3d& t) {
  return {r(0, 0), r(0, 1), r(0, 2), t[0], r(1, 0), r(1, 1), r(1, 2), t[1],
          r(2, 0), r(2, 1), r(2, 2), t[2], 0,       0,       0,       1};
}

/// Platform 0.9 m away, tilted, whose frame points towards the camera.
Platform tilted(double angle) {
  return {rays_of(kCamera), plane_of(pose_of(rotation_x(kPi - angle), {0.1, -0.05, 0.9}))};
}

cv::Point2d project(const cv::Vec3d& point) {
  return {kCamera.fx * point[0] / point[2] + kCamera.cx,
          kCamera.fy * point[1] / point[2] + kCamera.cy};
}

const cv::Matx33d kCovariance(0.04, 0.01, 0.001, 0.01, 0.09, -0.002, 0.001, -0.002, 0.0004);

double yaw(const cv::Matx33d& rotation) {
  return std::atan2(rotation(1, 0), rotation(0, 0));
}

TEST(Platform, PrincipalPointLiesOnTheAxis) {
  const auto pose = straight_down().lift({319.5, 239.5, 0}, kCovariance, 0);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(cv::norm(pose->position - cv::Vec3d(0, 0, 0.8)), 0, 1e-12);
  EXPECT_NEAR(cv::norm(pose->rotation - cv::Matx33d::eye()), 0, 1e-9);
}

TEST(Platform, YawIsThetaStraightFromAbove) {
  const PinholeCamera square{600, 600, 319.5, 239.5};
  const Platform platform(rays_of(square), plane_at(0.8));
  for (double theta = -3; theta <= 3; theta += 0.5) {
    const auto pose = platform.lift({100, 400, theta}, kCovariance, 0.02);
    ASSERT_TRUE(pose);
    EXPECT_NEAR(yaw(pose->rotation), theta, 1e-9);
    EXPECT_NEAR(pose->rotation(2, 2), 1, 1e-12);
  }
}

TEST(Platform, ObjectHeightLiftsThePlane) {
  const auto flat = straight_down().lift({500, 100, 0}, kCovariance, 0);
  const auto high = straight_down().lift({500, 100, 0}, kCovariance, 0.1);
  ASSERT_TRUE(flat && high);
  EXPECT_NEAR(high->position[2], 0.7, 1e-12);
  EXPECT_NEAR(high->position[0] / flat->position[0], 0.7 / 0.8, 1e-12);
}

TEST(Platform, PositionProjectsBackToThePixel) {
  for (const double angle : {-0.4, 0.0, 0.3}) {
    for (const double height : {0.0, 0.05}) {
      const Pose2D seen{420.5, 77.25, 1};
      const auto pose = tilted(angle).lift(seen, kCovariance, height);
      ASSERT_TRUE(pose);
      EXPECT_NEAR(cv::norm(project(pose->position) - seen.position()), 0, 1e-9);
    }
  }
}

TEST(Platform, PointsLieOnTheTiltedPlane) {
  const cv::Matx33d rotation = rotation_x(kPi - 0.3);
  const cv::Vec3d origin(0.1, -0.05, 0.9), up(rotation(0, 2), rotation(1, 2), rotation(2, 2));
  const auto pose = tilted(0.3).lift({420, 77, 1}, kCovariance, 0.05);
  ASSERT_TRUE(pose);
  EXPECT_NEAR((pose->position - origin).dot(up), 0.05, 1e-12);
}

TEST(Platform, RotationIsProperAndFollowsTheDirectionInTheImage) {
  const Pose2D seen{420, 77, 1.2};
  const auto pose = tilted(0.3).lift(seen, kCovariance, 0);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(cv::norm(pose->rotation * pose->rotation.t() - cv::Matx33d::eye()), 0, 1e-9);
  EXPECT_NEAR(cv::determinant(pose->rotation), 1, 1e-9);
  const cv::Vec3d along(pose->rotation(0, 0), pose->rotation(1, 0), pose->rotation(2, 0));
  const cv::Point2d step = project(pose->position + 1e-5 * along) - seen.position();
  EXPECT_NEAR(std::atan2(step.y, step.x), seen.theta, 1e-4);
}

TEST(Platform, DirectionOfTheFramesZAxisDoesNotMatter) {
  const cv::Vec3d origin(0, 0, 0.8);
  const Platform away(rays_of(kCamera), plane_of(pose_of(cv::Matx33d::eye(), origin)));
  const Platform back(rays_of(kCamera), plane_of(pose_of(rotation_x(kPi), origin)));
  const Pose2D seen{200, 300, 0.4};
  const auto a = away.lift(seen, kCovariance, 0.03), b = back.lift(seen, kCovariance, 0.03);
  const auto c = straight_down().lift(seen, kCovariance, 0.03);
  ASSERT_TRUE(a && b && c);
  EXPECT_NEAR(cv::norm(a->position - c->position), 0, 1e-12);
  EXPECT_NEAR(cv::norm(b->position - c->position), 0, 1e-12);
}

TEST(Platform, CovarianceIsThatOfSamples) {
  const Platform platform = tilted(0.25);
  const Pose2D seen{420, 77, 0.7};
  const auto pose = platform.lift(seen, kCovariance, 0);
  ASSERT_TRUE(pose);
  // Samples x, y, theta = L n with L L^t = covariance.
  const cv::Matx33d l(0.2, 0, 0, 0.05, std::sqrt(0.09 - 0.0025), 0, 0.005,
                      (-0.002 - 0.05 * 0.005) / std::sqrt(0.09 - 0.0025), 0.0183);
  cv::RNG random(5);
  cv::Matx66d sum = cv::Matx66d::zeros();
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const cv::Vec3d d = l * cv::Vec3d(random.gaussian(1), random.gaussian(1), random.gaussian(1));
    const auto sample =
        platform.lift({seen.x + d[0], seen.y + d[1], seen.theta + d[2]}, kCovariance, 0);
    const cv::Vec3d shift = sample->position - pose->position;
    const cv::Matx33d r = sample->rotation * pose->rotation.t();
    const cv::Matx<double, 6, 1> e(shift[0], shift[1], shift[2], (r(2, 1) - r(1, 2)) / 2,
                                   (r(0, 2) - r(2, 0)) / 2, (r(1, 0) - r(0, 1)) / 2);
    sum += e * e.t();
  }
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      const double scale = std::sqrt(pose->covariance(row, row) * pose->covariance(column, column));
      EXPECT_NEAR(sum(row, column) / kCount, pose->covariance(row, column), 0.05 * scale + 1e-12)
          << row << " " << column;
    }
  }
}

TEST(Platform, MetresPerPixelStraightDown) {
  const auto scale = straight_down().metres_per_pixel({50, 60}, 0.2);
  ASSERT_TRUE(scale);
  EXPECT_NEAR(*scale, 0.6 / std::sqrt(600.0 * 610.0), 1e-9);
}

TEST(Platform, NoPoseWhereTheRayMissesThePlane) {
  EXPECT_FALSE(straight_down().lift({320, 240, 0}, kCovariance, 0.9)) << "above the camera";
  const Platform steep = tilted(1.45);
  EXPECT_TRUE(!steep.lift({320, -20000, 0}, kCovariance, 0) ||
              !steep.lift({320, 20000, 0}, kCovariance, 0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(straight_down().lift({nan, 240, 0}, kCovariance, 0));
  EXPECT_FALSE(straight_down().lift({320, 240, 0}, kCovariance, nan));
  EXPECT_FALSE(straight_down().metres_per_pixel({nan, 0}, 0));
}

TEST(Platform, UnusableCalibrationsAreDetected) {
  const cv::Matx33d good(600, 0, 320, 0, 600, 240, 0, 0, 1);
  const cv::Size size(640, 480);
  EXPECT_TRUE(usable_camera(good, size, size));
  EXPECT_FALSE(usable_camera(cv::Matx33d::zeros(), size, size));
  EXPECT_FALSE(usable_camera(good, {1280, 960}, size));
  EXPECT_FALSE(usable_camera(good, {}, {}));
  for (const double bad : {0.0, -600.0, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    cv::Matx33d matrix = good;
    matrix(0, 0) = bad;
    EXPECT_FALSE(usable_camera(matrix, size, size)) << bad;
    matrix = good;
    matrix(1, 1) = bad;
    EXPECT_FALSE(usable_camera(matrix, size, size)) << bad;
  }
}

TEST(Platform, ImplausibleIntrinsicsAreNamed) {
  const cv::Size size(640, 480);
  const auto fault = [&](int row, int column, double value) {
    cv::Matx33d matrix(600, 0, 320, 0, 600, 240, 0, 0, 1);
    matrix(row, column) = value;
    return fault_of_camera(matrix, size);
  };
  EXPECT_EQ(fault(0, 0, 600), "");
  EXPECT_EQ(fault(0, 0, 1000), "");
  EXPECT_NE(fault(0, 0, 1300), "") << "twice the other";
  EXPECT_NE(fault(1, 1, 63), "") << "a tenth of the image";
  EXPECT_NE(fault(1, 1, 64001), "") << "a hundred images";
  EXPECT_EQ(fault(0, 2, -320), "");
  EXPECT_EQ(fault(0, 2, 960), "");
  for (const double beside : {-321., 961., 1e9}) EXPECT_NE(fault(0, 2, beside), "") << beside;
  for (const double beside : {-241., 721., -1e9}) EXPECT_NE(fault(1, 2, beside), "") << beside;
  EXPECT_NE(fault(0, 1, 0.01), "") << "skew";
  EXPECT_NE(fault(1, 0, -0.01), "") << "skew";
  for (const int column : {0, 1, 2}) EXPECT_NE(fault(2, column, 1.01), "") << "last row " << column;
  EXPECT_NE(fault(2, 2, std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(fault_of_camera({64, 0, 320, 0, 64, 240, 0, 0, 1}, size), "");
  EXPECT_EQ(fault_of_camera({64000, 0, 320, 0, 64000, 240, 0, 0, 1}, size), "");
  EXPECT_NE(fault_of_camera({63, 0, 320, 0, 63, 240, 0, 0, 1}, size), "");
  EXPECT_NE(fault_of_camera({64001, 0, 320, 0, 64001, 240, 0, 0, 1}, size), "");
}

TEST(Platform, PosesTooNearOrTooFarAreRefused) {
  EXPECT_TRUE(straight_down(99).lift({320, 240, 0}, kCovariance, 0));
  EXPECT_FALSE(straight_down(101).lift({320, 240, 0}, kCovariance, 0));
  EXPECT_FALSE(straight_down(99).lift({3200, 240, 0}, kCovariance, 0)) << "far beside";
  EXPECT_FALSE(straight_down(0.8).lift({320, 240, 0}, kCovariance, 0.7995));
  EXPECT_FALSE(straight_down(0.8).metres_per_pixel({320, 240}, 0.7995));
}

TEST(Platform, RefusesInvalidPlanes) {
  EXPECT_THROW(plane_at(0), std::invalid_argument);
  EXPECT_THROW(plane_at(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(plane_of(cv::Matx44d::zeros()), std::invalid_argument);
  EXPECT_THROW(plane_of(pose_of(2 * cv::Matx33d::eye(), {0, 0, 1})), std::invalid_argument);
  EXPECT_THROW(plane_of(pose_of(cv::Matx33d::eye(), {0.5, 0, 0})), std::invalid_argument);
}

}  // namespace
}  // namespace mbncc
