// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/top_view.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace mbncc {
namespace {

constexpr double kMostTilt = 60;  // [degrees] there, a pixel covers twice as much of the platform

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

}  // namespace mbncc
