// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/calibration.hpp"

#include <tf2_eigen/tf2_eigen.h>

#include "mbncc/cell/top_view.hpp"
#include "nodelets/conversion/camera_model.hpp"
#include "nodelets/conversion/platform_intrinsics.hpp"
#include "nodelets/conversion/rays.hpp"
#include "nodelets/conversion/tf_wait.hpp"

namespace mbncc::nodelets {
namespace {

Calibration uncalibrated(const std::string& fault) {
  Calibration calibration;
  calibration.fault = fault;
  return calibration;
}

Calibration over_platform(const PixelToRay& ray, const PlatformConfig& config,
                          const std_msgs::Header& header, cv::Size size,
                          const tf2_ros::Buffer& tf) {
  Calibration calibration;
  if (!config.platform_frame.empty())
    calibration.T_camera_platform = tf2::transformToEigen(
        tf.lookupTransform(camera_frame_of(config, header), config.platform_frame, header.stamp));
  const Plane plane = calibration.T_camera_platform ? plane_of(*calibration.T_camera_platform)
                                                    : plane_at(config.platform_distance);
  calibration.platform = Platform(ray, plane);
  calibration.distortion = distortion_of(*calibration.platform, size);
  calibration.tilt = tilt_of(plane);
  const cv::Point2d middle((size.width - 1) / 2.0, (size.height - 1) / 2.0);
  if (calibration.platform->meet(middle, 0)) return calibration;
  return uncalibrated(
      "platform: the ray through the image centre does not meet the platform 1 mm to 100 m in "
      "front of the camera; check camera_info, platform_frame and the camera's frame");
}

}  // namespace

std::string camera_frame_of(const PlatformConfig& config, const std_msgs::Header& header) {
  return config.camera_frame.empty() ? header.frame_id : config.camera_frame;
}

bool has_platform(const PlatformConfig& config) {
  return !config.platform_frame.empty() || config.platform_distance > 0;
}

Plane plane_of(const Eigen::Isometry3d& T_camera_platform) {
  cv::Matx44d matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix(row, column) = T_camera_platform(row, column);
  return mbncc::plane_of(matrix);
}

Calibration calibrate(const PlatformConfig& config, const sensor_msgs::CameraInfo* info,
                      const std_msgs::Header& header, cv::Size size, const tf2_ros::Buffer& tf) {
  if (!has_platform(config))
    return uncalibrated("set platform_frame or platform_distance to get poses in metres");
  if (camera_frame_of(config, header).empty())
    return uncalibrated(
        "the images have no frame_id; let the camera or the goal set header.frame_id, or set "
        "camera_frame");
  if (info == nullptr) return uncalibrated(kNoCameraInfo);
  try {
    std::string fault = fault_of_calibration(*info, config.rectified, size);
    if (fault.empty() && !config.platform_frame.empty())
      fault = fault_of_platform_intrinsics(config.platform_intrinsics, *info);
    if (!fault.empty()) return uncalibrated(fault);
    return over_platform(*rays_of(*info, config.rectified, size), config, header, size, tf);
  } catch (const tf2::TransformException& error) {
    return uncalibrated("platform: " + tf_fault(error));
  } catch (const std::exception& error) {
    return uncalibrated(std::string("platform: ") + error.what());
  }
}

}  // namespace mbncc::nodelets
