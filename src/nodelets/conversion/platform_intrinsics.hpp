// SPDX-License-Identifier: BSD-3-Clause
// Compares the camera that the platform was calibrated with and the one in use.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <string>

namespace mbncc::nodelets {

/// Throws ConfigError unless `text` is empty or "MODEL WIDTH HEIGHT FX FY CX CY D...", as
/// calibrate_platform writes it: `rectified`, of P and without D, or the distortion model of K and
/// D.
void check_platform_intrinsics(const std::string& text);

/// Why the pose of a platform that was calibrated with the camera `text` is not valid with `info`,
/// with the remedy; "" if it is, or if `text` is empty. It is valid if no pixel of the sensor has
/// moved by more than a tenth of a pixel of an undistorted image. Region of interest and binning do
/// not matter. Throws like check_platform_intrinsics().
std::string fault_of_platform_intrinsics(const std::string& text,
                                         const sensor_msgs::CameraInfo& info);

}  // namespace mbncc::nodelets
