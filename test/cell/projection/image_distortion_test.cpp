// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/image_distortion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace mbncc {
namespace {

const cv::Size kSize(640, 480);

/// A camera with radial distortion k1 and the principal point in the image's centre.
struct Camera {
  double focal_length = 600, k1 = 0;

  cv::Point2d pixel_of(const cv::Vec3d& ray) const {
    const cv::Point2d u(ray[0] / ray[2], ray[1] / ray[2]);
    return focal_length * (1 + k1 * u.dot(u)) * u + cv::Point2d(319.5, 239.5);
  }

  PixelToRay rays() const {
    return [*this](cv::Point2d pixel) {
      const cv::Point2d distorted = (pixel - cv::Point2d(319.5, 239.5)) / focal_length;
      cv::Point2d u = distorted;
      for (int i = 0; i < 50; ++i) u = distorted / (1 + k1 * u.dot(u));
      return cv::Vec3d(u.x, u.y, 1);
    };
  }
};

Plane tilted(double degrees, double direction) {
  const double tilt = degrees * kPi / 180;
  return {{0, 0, 0.8},
          {std::sin(tilt) * std::cos(direction), std::sin(tilt) * std::sin(direction),
           -std::cos(tilt)}};
}

ImageDistortion distortion(const Camera& camera, const Plane& plane) {
  return distortion_of({camera.rays(), plane}, kSize);
}

TEST(ImageDistortion, IsZeroForAnIdealCameraLookingStraightDown) {
  const ImageDistortion none = distortion({}, plane_at(0.8));
  EXPECT_LT(none.shear, 1e-6);
  EXPECT_LT(none.bend, 1e-9);
}

TEST(ImageDistortion, GrowsWithTiltAndFieldOfView) {
  const auto yaw = [](const Camera& camera, double degrees) {
    return yaw_error_of(distortion(camera, tilted(degrees, 1)));
  };
  EXPECT_NEAR(yaw({}, 2) / yaw({}, 1), 2, 0.03);
  EXPECT_NEAR(yaw({600}, 1) / yaw({1200}, 1), 2, 0.05);
}

TEST(ImageDistortion, IncludesTheLens) {
  EXPECT_GT(yaw_error_of(distortion({600, -0.2}, plane_at(0.8))), 0.02);
  const double weak = yaw_error_of(distortion({600, -0.01}, plane_at(0.8)));
  EXPECT_GT(weak, 0.0005);
  EXPECT_LT(weak, 0.002);
}

TEST(ImageDistortion, IgnoresPixelsThatDoNotShowThePlatform) {
  const Camera camera;
  const PixelToRay half = [rays = camera.rays()](cv::Point2d pixel) {
    return pixel.x < 250 ? cv::Vec3d::all(std::numeric_limits<double>::quiet_NaN()) : rays(pixel);
  };
  const ImageDistortion seen = distortion_of({half, tilted(5, 1)}, kSize);
  EXPECT_GT(seen.shear, 0.5 * distortion(camera, tilted(5, 1)).shear);
  EXPECT_TRUE(std::isfinite(seen.shear) && std::isfinite(seen.bend));
}

TEST(ImageDistortion, WidensTheCovarianceByTheObjectsLength) {
  const std::vector<cv::Point2f> outline{{0, 0}, {30, 40}, {26, 43}, {-4, 3}};
  const ImageDistortion distortion{0.01, 2e-4};
  const auto wide = with_distortion(cv::Matx33d::eye(), distortion, outline);
  EXPECT_NEAR(wide(2, 2) - 1, std::pow(yaw_error_of(distortion), 2), 1e-12);
  EXPECT_NEAR(yaw_error_of(distortion), 0.011, 1e-12);
  EXPECT_NEAR(std::sqrt(wide(0, 0) - 1), 0.032 * 2e-4 * 50 * 50, 1e-5);
  EXPECT_EQ(wide(0, 0), wide(1, 1));
  EXPECT_EQ(wide(0, 1), 0);
  EXPECT_EQ(cv::norm(with_distortion(cv::Matx33d::eye(), {}, outline) - cv::Matx33d::eye()), 0);
}

/// A view learned at one position in the image and found by shift and rotation at another.
class TwoViews {
 public:
  TwoViews(const Camera& camera, const Plane& plane)
      : camera_(camera),
        platform_(camera.rays(), plane),
        plane_(plane),
        distortion_(distortion_of(platform_, kSize)) {
    x_ = cv::normalize(cv::Vec3d(1, 0, 0) - plane.normal[0] * plane.normal);
    y_ = x_.cross(plane.normal);
  }

  /// Errors of yaw and position, divided by the stated deviations (root mean square of both axes).
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
    const cv::Matx33d stated = with_distortion({}, distortion_, outline_of(b));
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
      pixels.push_back(camera_.pixel_of(plane_.point + p[0] * x_ + p[1] * y_));
    }
    return pixels;
  }

  Camera camera_;
  Platform platform_;
  Plane plane_;
  ImageDistortion distortion_;
  cv::Vec3d x_, y_;
};

/// Checks that the root mean square of the errors agrees with the stated deviations.
void expect_honest(const Camera& camera, const Plane& plane, const std::string& what) {
  TwoViews views(camera, plane);
  std::mt19937 random(3);
  constexpr int kPairs = 1000;
  double yaw = 0, position = 0;
  for (int i = 0; i < kPairs; ++i) {
    const auto [in_yaw, in_place] = views.errors(random);
    yaw += in_yaw * in_yaw / kPairs;
    position += in_place * in_place / kPairs;
  }
  EXPECT_GT(std::sqrt(yaw), 0.6) << what;
  EXPECT_LT(std::sqrt(yaw), 1.25) << what;
  EXPECT_GT(std::sqrt(position), 0.6) << what;
  EXPECT_LT(std::sqrt(position), 1.25) << what;
}

TEST(ImageDistortion, MakesPosesAsUncertainAsStated) {
  for (const double focal_length : {300., 600., 1500.})
    for (const double tilt : {2., 10., 20.})
      expect_honest({focal_length}, tilted(tilt, 1),
                    std::to_string(focal_length) + " px, tilt " + std::to_string(tilt));
  for (const double k1 : {-0.3, -0.1, -0.02, 0.1}) {
    expect_honest({600, k1}, plane_at(0.8), "k1 " + std::to_string(k1));
    expect_honest({600, k1}, tilted(5, 2), "tilted, k1 " + std::to_string(k1));
  }
}

}  // namespace
}  // namespace mbncc
