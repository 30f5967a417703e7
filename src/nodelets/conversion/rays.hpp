// SPDX-License-Identifier: BSD-3-Clause
// Rays through the pixels of a camera as camera_info describes it.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <opencv2/core.hpp>
#include <optional>

#include "mbncc/cell/platform.hpp"

namespace mbncc::nodelets {

/// Rays of a picture of `size`: by P when it is `rectified`, else by K with the distortion D
/// undone. A raw pixel whose distortion cannot be undone has a ray that is not finite. None where
/// fault_of_calibration() tells a fault.
std::optional<PixelToRay> rays_of(const sensor_msgs::CameraInfo& info, bool rectified,
                                  cv::Size size);

}  // namespace mbncc::nodelets
