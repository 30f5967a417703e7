// SPDX-License-Identifier: BSD-3-Clause
// Converts pixels to metres by intersecting the ray through a pixel with the plane of an object's
// top face. All positions are in the camera's optical frame: z along the optical axis, x right, y
// down.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "mbncc/cell/pinhole_camera.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc {

/// The platform's plane.
struct Plane {
  cv::Vec3d point;   ///< [m]
  cv::Vec3d normal;  ///< unit length, away from the platform on the camera's side
};

/// Plane perpendicular to the optical axis at `distance` [m]. Throws std::invalid_argument unless
/// it is positive and finite.
Plane plane_at(double distance);

/// Plane through the x and y axes of a frame given by its pose T_camera_platform. Throws
/// std::invalid_argument if the pose is not a finite rigid transform or the plane contains the
/// camera.
Plane plane_of(const cv::Matx44d& T_camera_platform);

/// Pose of an object frame: origin at the reference point on the top face, z into the platform, x
/// along the object's direction. If the camera points straight down, its yaw about z is the
/// image's theta.
struct PlatformPose {
  cv::Vec3d position;                 ///< [m]
  cv::Matx33d rotation;               ///< columns are the object's axes
  cv::Matx<double, 6, 6> covariance;  ///< x, y, z [m], rotation about x, y, z [rad]
};

class Platform {
 public:
  Platform(PixelToRay ray, const Plane& plane) : ray_(std::move(ray)), plane_(plane) {}

  /// Converts a pose in the image with its covariance (x, y, theta) to metres, for an object
  /// whose top face is `object_height` [m] above the platform. None when the ray does not meet that
  /// plane in front of the camera, 1 mm to 100 m away.
  std::optional<PlatformPose> lift(const Pose2D& pose, const cv::Matx33d& covariance,
                                   double object_height) const;

  /// Length [m] of a pixel's side on the plane at `object_height` [m] above the platform, the
  /// geometric mean over directions. None as for lift().
  std::optional<double> metres_per_pixel(cv::Point2d pixel, double object_height) const;

  /// Intersection [m] of the ray through the pixel with the plane at `object_height` [m] above the
  /// platform. None as for lift().
  std::optional<cv::Vec3d> meet(cv::Point2d pixel, double object_height) const;

 private:
  PixelToRay ray_;
  Plane plane_;
};

}  // namespace mbncc
