// SPDX-License-Identifier: BSD-3-Clause
// Error of poses from a search that only shifts and rotates a view, although the camera's tilt or
// its lens makes an object's appearance depend on its place in the image.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/cell/platform.hpp"

namespace mbncc {

/// Deviation of an image of the platform from constant scale: all 0 for a camera that looks
/// straight down through a lens without distortion.
struct ImageDistortion {
  double shear = 0;  ///< (a - b) / (a + b) of a pixel's longest and shortest extent a, b on the
                     ///< platform, root mean square over the image
  double bend = 0;   ///< [1/px] relative change of a pixel's extent in its own direction, root mean
                     ///< square over the image
};

/// Distortion of images of `size`. Places that do not show the platform are left out.
ImageDistortion distortion_of(const Platform& platform, cv::Size size);

/// Standard deviation [rad] of the yaw between two views anywhere in the image.
double yaw_error_of(const ImageDistortion& distortion);

/// Adds the uncertainty caused by distortion to the covariance (x, y, theta) [px, rad] of a pose.
/// `outline` [px] is that of the object in the image.
cv::Matx33d with_distortion(const cv::Matx33d& covariance, const ImageDistortion& distortion,
                            const std::vector<cv::Point2f>& outline);

}  // namespace mbncc
