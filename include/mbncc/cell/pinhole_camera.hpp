// SPDX-License-Identifier: BSD-3-Clause
// The rays of a camera without distortion, and whether its calibration is plausible.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

namespace mbncc {

/// Direction (of any length, z > 0) of the ray seen at a pixel of the image as received. The
/// function must correct lens distortion.
using PixelToRay = std::function<cv::Vec3d(cv::Point2d)>;

/// A camera without distortion.
struct PinholeCamera {
  double fx = 0, fy = 0;  ///< [px] focal lengths
  double cx = 0, cy = 0;  ///< [px] principal point
};

/// Why this camera matrix (K, or the left 3x3 part of P) is implausible for images of the
/// `calibrated` size: a number that is not finite, a last row other than 0 0 1, skew, a focal
/// length below a tenth or above a hundred times the longer side, pixels twice as long as wide, a
/// principal point farther from the image than half its size. "" if it is plausible.
std::string fault_of_camera(const cv::Matx33d& matrix, cv::Size calibrated);

/// The camera with this matrix. None if fault_of_camera() reports a fault, or if the calibration
/// was made for another image size.
std::optional<PinholeCamera> usable_camera(const cv::Matx33d& matrix, cv::Size calibrated,
                                           cv::Size image);

PixelToRay rays_of(const PinholeCamera& camera);

}  // namespace mbncc
