// SPDX-License-Identifier: BSD-3-Clause
// The simulated camera's optics: its calibration, and its image of the drawn scene. The drawing is
// a view from straight above without distortion.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <opencv2/core.hpp>

#include "mbncc/cell/platform.hpp"
#include "mbncc/config/simulated_camera_config.hpp"

namespace mbncc::nodelets {

class SimulatedOptics {
 public:
  explicit SimulatedOptics(const SimulatedCameraConfig& config);

  /// The calibration without header. Without a focal length, it contains only the image's size.
  const sensor_msgs::CameraInfo& camera_info() const { return info_; }

  /// The camera of the drawing.
  const PinholeCamera& pinhole() const { return camera_; }

  /// Rotation from the frame of the camera to that of the drawing's camera.
  const cv::Matx33d& rotation() const { return rotation_; }

  /// The camera's image of the drawing, which is mirrored beyond its edges.
  cv::Mat expose(const cv::Mat& drawing) const;

 private:
  PinholeCamera camera_;
  sensor_msgs::CameraInfo info_;
  cv::Matx33d rotation_;
  cv::Mat where_;  // CV_32FC2 position of each raw pixel in the drawing; empty: the same position
};

}  // namespace mbncc::nodelets
