// SPDX-License-Identifier: BSD-3-Clause
// The simulated camera's lens: its calibration, and its distortion of an image.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <opencv2/core.hpp>

#include "mbncc/cell/platform.hpp"
#include "mbncc/config/simulated_camera_config.hpp"

namespace mbncc::nodelets {

class SimulatedOptics {
 public:
  explicit SimulatedOptics(const SimulatedCameraConfig& config);

  /// Without header; without a focal length only the image's size.
  const sensor_msgs::CameraInfo& camera_info() const { return info_; }

  /// The camera of the undistorted image.
  const PinholeCamera& pinhole() const { return camera_; }

  /// The distorted version of an undistorted image, which is mirrored beyond its edges.
  cv::Mat distort(const cv::Mat& undistorted) const;

 private:
  PinholeCamera camera_;
  sensor_msgs::CameraInfo info_;
  cv::Mat where_;  // CV_32FC2 position of each raw pixel in the undistorted image; empty: no
                   // distortion
};

}  // namespace mbncc::nodelets
