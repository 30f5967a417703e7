// SPDX-License-Identifier: BSD-3-Clause
// Rays through the pixels of a camera described by camera_info.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <opencv2/core.hpp>
#include <optional>

#include "mbncc/cell/platform.hpp"

namespace mbncc::nodelets {

/// Rays of an image of `size`: computed from P if it is `rectified`, otherwise from K and D. A raw
/// pixel whose distortion cannot be inverted has a ray that is not finite. None if
/// fault_of_calibration() reports a fault.
std::optional<PixelToRay> rays_of(const sensor_msgs::CameraInfo& info, bool rectified,
                                  cv::Size size);

}  // namespace mbncc::nodelets
