// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/top_view.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

namespace mbncc {
namespace {

constexpr double kMostTilt = 60;  // [degrees] where a pixel covers twice as much of the platform
// Between random places and directions, for focal lengths of .5 to 2.3 image widths and tilts of 2
// to 20 degrees, the root mean square is .9 of what these give (top_view_test.cpp).
constexpr double kYawError = 0.3;        // per tangent of the tilt and of the field
constexpr double kPositionError = 0.04;  // of the object's length, per tangents of tilt and length

cv::Point2d middle_of(cv::Size size) {
  return {(size.width - 1) / 2.0, (size.height - 1) / 2.0};
}

/// The smallest rotation that takes one unit vector to another, which is not its opposite
/// (Rodrigues' formula).
cv::Matx33d rotation_between(const cv::Vec3d& from, const cv::Vec3d& to) {
  const cv::Vec3d v = from.cross(to);
  const cv::Matx33d cross(0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0);
  return cv::Matx33d::eye() + cross + cross * cross * (1 / (1 + from.dot(to)));
}

/// Cosine of a ray's angle to the optical axis.
double cosine(const cv::Vec3d& ray) {
  return ray[2] / cv::norm(ray);
}

double tangent_between(const cv::Vec3d& a, const cv::Vec3d& b) {
  return cv::norm(a.cross(b)) / a.dot(b);
}

void refuse(double tilt, const std::string& why) {
  throw std::invalid_argument("the camera is tilted by " + std::to_string(std::lround(tilt)) +
                              " degrees, " + why + "; mount it more upright");
}

}  // namespace

double tilt_of(const Plane& platform) {
  return std::acos(std::clamp(-platform.normal[2], -1.0, 1.0));
}

TurnedCamera top_view(const PinholeCamera& camera, const Plane& platform, cv::Size size) {
  const double tilt = tilt_of(platform) * 180 / CV_PI;
  if (!(tilt <= kMostTilt)) refuse(tilt, "too much for a view from above");
  TurnedCamera turned;
  turned.rotation = rotation_between(-platform.normal, {0, 0, 1});
  const cv::Vec3d ray = rays_of(camera)(middle_of(size));
  const cv::Vec3d turned_ray = turned.rotation * ray;
  // A pixel's solid angle is proportional to the cubed cosine of its ray's angle to the axis.
  const double focal_length =
      std::sqrt(camera.fx * camera.fy * std::pow(cosine(turned_ray) / cosine(ray), 3));
  const cv::Point2d principal =
      middle_of(size) - focal_length / turned_ray[2] * cv::Point2d(turned_ray[0], turned_ray[1]);
  turned.camera = {focal_length, focal_length, principal.x, principal.y};
  const cv::Matx33d matrix(focal_length, 0, principal.x, 0, focal_length, principal.y, 0, 0, 1);
  if (!(turned_ray[2] > 0) || !fault_of_camera(matrix, size).empty())
    refuse(tilt, "so that its images show too little of what lies below it");
  return turned;
}

Perspective perspective_of(const PixelToRay& ray, const Plane& platform, cv::Size size) {
  const cv::Vec3d middle = ray(middle_of(size));
  Perspective perspective{tilt_of(platform), 0, 0};
  for (const double x : {0.0, size.width - 1.0})
    for (const double y : {0.0, size.height - 1.0}) {
      const double angle = tangent_between(middle, ray({x, y}));
      // Where a lens shows nothing, or behind the camera, it is as wide as can be.
      perspective.field = angle >= 0 ? std::max(perspective.field, angle) : 1;
    }
  perspective.pixel = perspective.field / cv::norm(middle_of(size));
  return perspective;
}

double yaw_error_of(const Perspective& perspective) {
  const double across = std::abs(std::tan(perspective.tilt)) * perspective.field;
  const double foreshortening = (1 / std::abs(std::cos(perspective.tilt)) - 1) / 2;
  return std::hypot(kYawError * across, foreshortening);
}

cv::Matx33d with_perspective(const cv::Matx33d& covariance, const Perspective& perspective,
                             const std::vector<cv::Point2f>& outline) {
  const cv::Size2f size = outline.empty() ? cv::Size2f() : cv::minAreaRect(outline).size;
  const double length = std::max(size.width, size.height);
  const double position =
      kPositionError * std::abs(std::tan(perspective.tilt)) * perspective.pixel * length * length;
  const double yaw = yaw_error_of(perspective);
  return covariance + cv::Matx33d::diag({position * position, position * position, yaw * yaw});
}

}  // namespace mbncc
