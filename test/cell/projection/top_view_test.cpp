// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/top_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <random>
#include <stdexcept>
#include <vector>

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

TEST(TopView, OfAnUprightCameraIsItsOwn) {
  const PinholeCamera square{600, 600, 330, 250};
  const TurnedCamera view = top_view(square, plane_at(0.8), kSize);
  EXPECT_NEAR(cv::norm(view.rotation - cv::Matx33d::eye()), 0, 1e-12);
  EXPECT_NEAR(view.camera.fx, 600, 1e-9);
  EXPECT_NEAR(view.camera.cx, 330, 1e-9);
  EXPECT_NEAR(view.camera.cy, 250, 1e-9);
}

TEST(TopView, IsRefusedWhereItWouldShowTooLittle) {
  EXPECT_NO_THROW(top_view(kCamera, tilted(30, 1), kSize));
  EXPECT_THROW(top_view(kCamera, tilted(61, 1), kSize), std::invalid_argument);
  EXPECT_THROW(top_view(kCamera, tilted(170, 1), kSize), std::invalid_argument);
  const PinholeCamera telephoto{6000, 6000, 330, 250};
  EXPECT_NO_THROW(top_view(telephoto, tilted(2, 1), kSize));
  EXPECT_THROW(top_view(telephoto, tilted(20, 1), kSize), std::invalid_argument);
}

TEST(Perspective, GrowsWithTiltAndFieldOfView) {
  const Perspective none = perspective_of(rays_of(kCamera), plane_at(0.8), kSize);
  EXPECT_EQ(none.tilt, 0);
  EXPECT_EQ(yaw_error_of(none), 0);
  const auto error = [](const PinholeCamera& camera, double tilt) {
    return yaw_error_of(perspective_of(rays_of(camera), tilted(tilt, 1), kSize));
  };
  EXPECT_NEAR(error(kCamera, 2) / error(kCamera, 1), 2, 0.01);
  EXPECT_NEAR(error(kCamera, 1) / error({1200, 1240, 330, 250}, 1), 2, 0.05);
}

TEST(Perspective, WidensTheCovarianceByTheObjectsLength) {
  const std::vector<cv::Point2f> outline{{0, 0}, {30, 40}, {26, 43}, {-4, 3}};
  const Perspective perspective{0.1, 0.6, 0.0015};
  const auto wide = with_perspective(cv::Matx33d::eye(), perspective, outline);
  EXPECT_NEAR(wide(2, 2) - 1, std::pow(yaw_error_of(perspective), 2), 1e-12);
  EXPECT_GT(yaw_error_of(perspective), 0.015);
  EXPECT_NEAR(std::sqrt(wide(0, 0) - 1), 0.04 * std::tan(0.1) * 0.0015 * 50 * 50, 1e-6);
  EXPECT_EQ(wide(0, 0), wide(1, 1));
  EXPECT_EQ(wide(0, 1), 0);
  EXPECT_EQ(cv::norm(with_perspective(cv::Matx33d::eye(), {}, outline) - cv::Matx33d::eye()), 0);
}

/// A view learned at one place of a tilted camera's image and found by shift and rotation at
/// another.
class TwoViews {
 public:
  TwoViews(const PinholeCamera& camera, const Plane& plane)
      : camera_(camera), platform_(rays_of(camera), plane), plane_(plane) {
    x_ = cv::normalize(cv::Vec3d(1, 0, 0) - plane.normal[0] * plane.normal);
    y_ = x_.cross(plane.normal);
  }

  /// Errors in units of what is stated: of yaw, and of position (root mean square of both axes).
  std::pair<double, double> errors(std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> aspect(0.2, 1);
    std::vector<cv::Point2d> points;
    const double slim = aspect(random);
    for (int i = 0; i < 40; ++i)
      points.emplace_back(0.03 * normal(random), 0.03 * slim * normal(random));
    const Placed learned = place(random), found = place(random);
    const auto a = image_of(points, learned), b = image_of(points, found);
    const cv::Point2d reference = mean(a), centre = mean(b);
    std::complex<double> turn;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const cv::Point2d p = a[i] - reference, q = b[i] - centre;
      turn += std::complex<double>(q.x, q.y) * std::conj(std::complex<double>(p.x, p.y));
    }
    const PlatformPose shown = *platform_.lift({reference.x, reference.y, 0}, {}, 0);
    const cv::Matx33d stated =
        with_perspective({}, perspective_of(rays_of(camera_), plane_, kSize), outline_of(b));
    const PlatformPose pose = *platform_.lift({centre.x, centre.y, std::arg(turn)}, stated, 0);
    const double moved = found.theta - learned.theta;
    const cv::Vec2d offset = in_plane(shown.position) - learned.position;
    const cv::Vec2d expected = found.position + rotated(offset, moved);
    const double yaw = std::remainder(yaw_of(pose) - yaw_of(shown) - moved, 2 * kPi);
    const double yaw_variance = cv::trace(pose.covariance.get_minor<3, 3>(3, 3));
    const double place_variance = cv::trace(pose.covariance.get_minor<3, 3>(0, 0));
    return {yaw / std::sqrt(yaw_variance),
            cv::norm(in_plane(pose.position) - expected) / std::sqrt(place_variance)};
  }

 private:
  struct Placed {
    cv::Vec2d position;
    double theta;
  };

  static cv::Vec2d rotated(const cv::Vec2d& p, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p[0] - s * p[1], s * p[0] + c * p[1]};
  }

  static cv::Point2d mean(const std::vector<cv::Point2d>& points) {
    cv::Point2d sum;
    for (const auto& point : points) sum += point;
    return sum / static_cast<double>(points.size());
  }

  static std::vector<cv::Point2f> outline_of(const std::vector<cv::Point2d>& points) {
    return {points.begin(), points.end()};
  }

  cv::Vec2d in_plane(const cv::Vec3d& point) const {
    return {x_.dot(point - plane_.point), y_.dot(point - plane_.point)};
  }

  double yaw_of(const PlatformPose& pose) const {
    const cv::Vec3d ahead(pose.rotation(0, 0), pose.rotation(1, 0), pose.rotation(2, 0));
    return std::atan2(y_.dot(ahead), x_.dot(ahead));
  }

  Placed place(std::mt19937& random) const {
    std::uniform_real_distribution<double> x(60, 580), y(60, 420), theta(-kPi, kPi);
    return {in_plane(*platform_.meet({x(random), y(random)}, 0)), theta(random)};
  }

  std::vector<cv::Point2d> image_of(const std::vector<cv::Point2d>& points,
                                    const Placed& placed) const {
    std::vector<cv::Point2d> pixels;
    for (const auto& point : points) {
      const cv::Vec2d p = placed.position + rotated({point.x, point.y}, placed.theta);
      pixels.push_back(pixel_of(camera_, plane_.point + p[0] * x_ + p[1] * y_));
    }
    return pixels;
  }

  PinholeCamera camera_;
  Platform platform_;
  Plane plane_;
  cv::Vec3d x_, y_;
};

TEST(Perspective, MakesPosesAsUncertainAsStated) {
  std::mt19937 random(3);
  for (const double focal_length : {300., 600., 1500.})
    for (const double tilt : {2., 10., 20.}) {
      TwoViews views({focal_length, focal_length, 319.5, 239.5}, tilted(tilt, 1));
      double yaw = 0, position = 0;
      constexpr int kPairs = 600;
      for (int i = 0; i < kPairs; ++i) {
        const auto [in_yaw, in_place] = views.errors(random);
        yaw += in_yaw * in_yaw / kPairs;
        position += in_place * in_place / kPairs;
      }
      EXPECT_GT(std::sqrt(yaw), 0.6) << focal_length << " px, " << tilt << " degrees";
      EXPECT_LT(std::sqrt(yaw), 1.3) << focal_length << " px, " << tilt << " degrees";
      EXPECT_GT(std::sqrt(position), 0.6) << focal_length << " px, " << tilt << " degrees";
      EXPECT_LT(std::sqrt(position), 1.3) << focal_length << " px, " << tilt << " degrees";
    }
}

}  // namespace
}  // namespace mbncc
