// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/platform.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace mbncc {
namespace {

constexpr double kStep = 0.5;        // [px] step of numerical derivatives
constexpr double kAngleStep = 1e-3;  // [rad] step of numerical derivatives
constexpr double kRigidTolerance = 1e-3;
constexpr double kNearest = 0.001, kFarthest = 100;  // [m] limits of the distance from the camera

struct Frame {
  cv::Vec3d position;
  cv::Matx33d rotation;
};

cv::Matx33d from_columns(const cv::Vec3d& x, const cv::Vec3d& y, const cv::Vec3d& z) {
  return {x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]};
}

/// Rotation vector of a small rotation.
cv::Vec3d small_rotation(const cv::Matx33d& r) {
  return cv::Vec3d(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)) * 0.5;
}

/// Derivative of the frame (position and rotation vector) with respect to a parameter, whose values
/// at `low` and `high` are `width` apart.
cv::Matx<double, 6, 1> derivative(const Frame& low, const Frame& high, double width) {
  const cv::Vec3d shift = (high.position - low.position) / width;
  const cv::Vec3d turn = small_rotation(high.rotation * low.rotation.t()) / width;
  return {shift[0], shift[1], shift[2], turn[0], turn[1], turn[2]};
}

}  // namespace

Plane plane_at(double distance) {
  if (!(distance > 0) || !std::isfinite(distance))
    throw std::invalid_argument("the platform's distance must be positive and finite");
  return {{0, 0, distance}, {0, 0, -1}};
}

Plane plane_of(const cv::Matx44d& T_camera_platform) {
  const cv::Matx33d rotation = T_camera_platform.get_minor<3, 3>(0, 0);
  const cv::Vec3d point(T_camera_platform(0, 3), T_camera_platform(1, 3), T_camera_platform(2, 3));
  const double fault = cv::norm(rotation * rotation.t() - cv::Matx33d::eye());
  if (!cv::checkRange(T_camera_platform) || !(fault < kRigidTolerance))
    throw std::invalid_argument("the platform's pose must be finite and rigid");
  cv::Vec3d normal(rotation(0, 2), rotation(1, 2), rotation(2, 2));
  const double height = -normal.dot(point);
  if (height == 0) throw std::invalid_argument("the camera lies in the platform's plane");
  // The camera is above the platform, whatever the direction of the frame's z.
  return {point, height > 0 ? normal : -normal};
}

std::optional<cv::Vec3d> Platform::meet(cv::Point2d pixel, double object_height) const {
  const cv::Vec3d ray = ray_(pixel);
  const double slope = ray.dot(plane_.normal);
  const double height = plane_.normal.dot(plane_.point) + object_height;
  const double distance = height / slope;
  // The camera must be above the plane and look down on it.
  if (!(height < 0 && slope < 0)) return std::nullopt;
  const cv::Vec3d place = ray * distance;
  const double away = cv::norm(place);
  if (!(away >= kNearest && away <= kFarthest)) return std::nullopt;
  return place;
}

std::optional<double> Platform::metres_per_pixel(cv::Point2d pixel, double object_height) const {
  const auto left = meet(pixel - cv::Point2d(kStep, 0), object_height);
  const auto right = meet(pixel + cv::Point2d(kStep, 0), object_height);
  const auto up = meet(pixel - cv::Point2d(0, kStep), object_height);
  const auto down = meet(pixel + cv::Point2d(0, kStep), object_height);
  if (!left || !right || !up || !down) return std::nullopt;
  return std::sqrt(cv::norm((*right - *left).cross(*down - *up))) / (2 * kStep);
}

std::optional<PlatformPose> Platform::lift(const Pose2D& pose, const cv::Matx33d& covariance,
                                           double object_height) const {
  const auto frame_at = [&](double dx, double dy, double dtheta) -> std::optional<Frame> {
    const cv::Point2d centre = pose.position() + cv::Point2d(dx, dy);
    const cv::Point2d ahead = rotate({kStep, 0}, pose.theta + dtheta);
    const auto origin = meet(centre, object_height);
    const auto back = meet(centre - ahead, object_height),
               front = meet(centre + ahead, object_height);
    if (!origin || !back || !front) return std::nullopt;
    const cv::Vec3d x = cv::normalize(*front - *back), z = -plane_.normal;
    return Frame{*origin, from_columns(x, z.cross(x), z)};
  };
  const auto frame = frame_at(0, 0, 0);
  if (!frame) return std::nullopt;
  const std::array<cv::Vec3d, 3> steps{{{kStep, 0, 0}, {0, kStep, 0}, {0, 0, kAngleStep}}};
  cv::Matx<double, 6, 3> jacobian;
  for (int i = 0; i < 3; ++i) {
    const cv::Vec3d& d = steps[i];
    const auto low = frame_at(-d[0], -d[1], -d[2]), high = frame_at(d[0], d[1], d[2]);
    if (!low || !high) return std::nullopt;
    const auto column = derivative(*low, *high, 2 * d[i]);
    for (int row = 0; row < 6; ++row) jacobian(row, i) = column(row);
  }
  return PlatformPose{frame->position, frame->rotation, jacobian * covariance * jacobian.t()};
}

}  // namespace mbncc
