// SPDX-License-Identifier: BSD-3-Clause
// Determines the platform below the camera from camera_info, parameters and tf.
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <std_msgs/Header.h>
#include <tf2_ros/buffer.h>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "mbncc/cell/image_distortion.hpp"
#include "mbncc/cell/platform.hpp"
#include "mbncc/config/platform_config.hpp"

namespace mbncc::nodelets {

struct Calibration {
  std::optional<Platform> platform;  ///< none: poses only in pixels
  std::string fault;                 ///< why there is no platform, with the remedy
  std::optional<Eigen::Isometry3d> T_camera_platform;  ///< pose of platform_frame, if it is set
  ImageDistortion distortion;  ///< deviation of the image from a constant scale
  double tilt = 0;             ///< [rad] between the optical axis and the platform's normal
};

/// Whether the parameters describe a platform, so that poses in metres are wanted.
bool has_platform(const PlatformConfig& config);

/// Optical frame of an image: the configured one, otherwise the frame in its header.
std::string camera_frame_of(const PlatformConfig& config, const std_msgs::Header& header);

/// Plane through the frame's x and y axes. Throws like plane_of(cv::Matx44d).
Plane plane_of(const Eigen::Isometry3d& T_camera_platform);

/// Calibration of one image of `size`. `info` may be null. Never waits for tf.
Calibration calibrate(const PlatformConfig& config, const sensor_msgs::CameraInfo* info,
                      const std_msgs::Header& header, cv::Size size, const tf2_ros::Buffer& tf);

}  // namespace mbncc::nodelets
