// SPDX-License-Identifier: BSD-3-Clause
// Simulated images that tests publish: one part on a platform, under a camera without distortion.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include "mbncc/sim/scene.hpp"

namespace mbncc::nodelets {

constexpr double kFocalLength = 500;                  // [px]
constexpr double kCentreX = 199.5, kCentreY = 149.5;  // [px]

inline sim::SceneConfig drawn_scene() {
  sim::SceneConfig config;
  config.size = {400, 300};
  config.seed = 5;
  return config;
}

/// The part with a size of `diameter` [px].
inline sim::Placed drawn_part(double diameter, const Pose2D& pose) {
  return {{11, diameter, 1.6}, pose};
}

/// The calibration for the images of the scene.
inline sensor_msgs::CameraInfo drawn_camera_info(const std_msgs::Header& header) {
  sensor_msgs::CameraInfo info;
  info.header = header;
  info.width = 400;
  info.height = 300;
  info.distortion_model = "plumb_bob";
  info.D.assign(5, 0);
  info.K = {kFocalLength, 0, kCentreX, 0, kFocalLength, kCentreY, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {kFocalLength, 0, kCentreX, 0, 0, kFocalLength, kCentreY, 0, 0, 0, 1, 0};
  return info;
}

}  // namespace mbncc::nodelets
