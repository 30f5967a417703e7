// SPDX-License-Identifier: BSD-3-Clause
// The platform as seen by a camera at the same place that looks straight down (fronto-parallel
// rectification). Objects are then shifted and rotated without perspective, as the search assumes.
// A camera that only turns about its centre sees the same rays, so the view holds at every height
// (Hartley and Zisserman, Multiple View Geometry, section 8.4).
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/cell/pinhole_camera.hpp"
#include "mbncc/cell/platform.hpp"

namespace mbncc {

/// A camera turned about its centre.
struct TurnedCamera {
  cv::Matx33d rotation = cv::Matx33d::eye();  ///< from the given camera's frame to the turned one's
  PinholeCamera camera;                       ///< [px]
};

/// Angle [rad] between the optical axis and the platform's normal, 0 to pi.
double tilt_of(const Plane& platform);

/// `camera`, turned by the smallest angle that makes it look straight down on the platform. The
/// middle of an image of `size` still shows the same place, and a pixel there still covers the same
/// solid angle. Throws std::invalid_argument with the remedy if the platform would lie outside
/// usable images: a tilt above 60 degrees, or a principal point that fault_of_camera() rejects.
TurnedCamera top_view(const PinholeCamera& camera, const Plane& platform, cv::Size size);

}  // namespace mbncc
