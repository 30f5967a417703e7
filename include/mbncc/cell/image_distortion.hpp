// SPDX-License-Identifier: BSD-3-Clause
// The error of poses that are found by shifting and rotating a view, where the camera's tilt or its
// lens changes the view of an object with its place in the image.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/cell/platform.hpp"

namespace mbncc {

/// How far an image of the platform is from a map of constant scale: all 0 for a camera that looks
/// straight down through a lens without distortion.
struct ImageDistortion {
  double shear = 0;  ///< (a - b) / (a + b) of a pixel's longest and shortest extent a, b on the
                     ///< platform, root mean square over the image
  double bend = 0;   ///< [1/px] relative change of a pixel's extent along itself, likewise
};

/// Of images of `size`. Pixels that do not show the platform are left out.
ImageDistortion distortion_of(const Platform& platform, cv::Size size);

/// Standard deviation [rad] of the yaw between two views anywhere in the image.
double yaw_error_of(const ImageDistortion& distortion);

/// Adds what distortion makes uncertain to the covariance (x, y, theta) [px, rad] of a pose.
/// `outline` [px]: the object in the image.
cv::Matx33d with_distortion(const cv::Matx33d& covariance, const ImageDistortion& distortion,
                            const std::vector<cv::Point2f>& outline);

}  // namespace mbncc
