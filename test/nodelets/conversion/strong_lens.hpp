// SPDX-License-Identifier: BSD-3-Clause
// A calibrated camera for tests of calibrations.
#pragma once

#include <sensor_msgs/CameraInfo.h>

namespace mbncc::nodelets {

/// 1280 x 960 px with strong barrel distortion, and the principal point far from the centre.
inline sensor_msgs::CameraInfo strong_lens() {
  sensor_msgs::CameraInfo info;
  info.width = 1280;
  info.height = 960;
  info.distortion_model = "plumb_bob";
  info.D = {-0.3, 0.1, 0.001, -0.002, 0};
  info.K = {900, 0, 580, 0, 910, 530, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {800, 0, 600, 0, 0, 800, 500, 0, 0, 0, 1, 0};
  return info;
}

}  // namespace mbncc::nodelets
