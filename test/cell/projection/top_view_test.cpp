// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/top_view.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace mbncc {
namespace {

const cv::Size kSize(640, 480);
constexpr PinholeCamera kCamera{600, 620, 330, 250};

double radians(double degrees) {
  return degrees * kPi / 180;
}

/// The platform as seen by a camera tilted about both axes.
Plane tilted(double degrees, double direction) {
  const double tilt = radians(degrees);
  return {{0, 0, 0.8},
          {std::sin(tilt) * std::cos(direction), std::sin(tilt) * std::sin(direction),
           -std::cos(tilt)}};
}

cv::Point2d pixel_of(const PinholeCamera& camera, const cv::Vec3d& ray) {
  return {camera.fx * ray[0] / ray[2] + camera.cx, camera.fy * ray[1] / ray[2] + camera.cy};
}

TEST(TopView, LooksStraightDownAtTheSameMiddle) {
  for (const double direction : {0.0, 1.0, 2.5, 4.0}) {
    const Plane platform = tilted(25, direction);
    EXPECT_NEAR(tilt_of(platform), radians(25), 1e-12);
    const TurnedCamera view = top_view(kCamera, platform, kSize);
    EXPECT_NEAR(cv::norm(view.rotation * platform.normal - cv::Vec3d(0, 0, -1)), 0, 1e-12);
    EXPECT_NEAR(cv::norm(view.rotation * view.rotation.t() - cv::Matx33d::eye()), 0, 1e-12);
    EXPECT_NEAR(std::acos((cv::trace(view.rotation) - 1) / 2), radians(25), 1e-9) << "no more";
    const cv::Point2d middle(319.5, 239.5);
    const auto seen = [&](cv::Point2d pixel) {
      return pixel_of(view.camera, view.rotation * rays_of(kCamera)(pixel));
    };
    EXPECT_NEAR(cv::norm(seen(middle) - middle), 0, 1e-9);
    const cv::Point2d right = seen(middle + cv::Point2d(0.1, 0)) - middle;
    const cv::Point2d down = seen(middle + cv::Point2d(0, 0.1)) - middle;
    EXPECT_NEAR(right.cross(down), 0.01, 1e-5) << "a pixel covers as much there";
  }
}

TEST(TopView, OfAnUprightCameraEqualsItsImage) {
  const PinholeCamera square{600, 600, 330, 250};
  const TurnedCamera view = top_view(square, plane_at(0.8), kSize);
  EXPECT_NEAR(cv::norm(view.rotation - cv::Matx33d::eye()), 0, 1e-12);
  EXPECT_NEAR(view.camera.fx, 600, 1e-9);
  EXPECT_NEAR(view.camera.cx, 330, 1e-9);
  EXPECT_NEAR(view.camera.cy, 250, 1e-9);
}

TEST(TopView, IsRefusedIfItWouldShowTooLittle) {
  EXPECT_NO_THROW(top_view(kCamera, tilted(30, 1), kSize));
  EXPECT_THROW(top_view(kCamera, tilted(61, 1), kSize), std::invalid_argument);
  EXPECT_THROW(top_view(kCamera, tilted(170, 1), kSize), std::invalid_argument);
  const PinholeCamera telephoto{6000, 6000, 330, 250};
  EXPECT_NO_THROW(top_view(telephoto, tilted(2, 1), kSize));
  EXPECT_THROW(top_view(telephoto, tilted(20, 1), kSize), std::invalid_argument);
}

}  // namespace
}  // namespace mbncc
