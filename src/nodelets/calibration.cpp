#include "nodelets/calibration.hpp"

#include <image_geometry/pinhole_camera_model.h>
#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace mbncc::nodelets {
namespace {

cv::Matx33d camera_matrix(const sensor_msgs::CameraInfo& info, bool rectified) {
  if (!rectified) return cv::Matx33d(info.K.data());
  const auto& p = info.P;
  return {p[0], p[1], p[2], p[4], p[5], p[6], p[8], p[9], p[10]};
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// Rays through the pixels of a raw picture: distortion undone, directions in the optical frame.
std::optional<PixelToRay> distorted_rays(const sensor_msgs::CameraInfo& info) {
  auto undistorted = info;
  // Rectifying to K itself, without turning, leaves nothing but the distortion to undo.
  undistorted.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto& k = info.K;
  undistorted.P = {k[0], k[1], k[2], 0, k[3], k[4], k[5], 0, k[6], k[7], k[8], 0};
  const auto model = std::make_shared<image_geometry::PinholeCameraModel>();
  if (!all_finite(info.D) || !model->fromCameraInfo(undistorted)) return {};
  return [model](cv::Point2d pixel) {
    return cv::Vec3d(model->projectPixelTo3dRay(model->rectifyPoint(pixel)));
  };
}

std::optional<PixelToRay> rays(const sensor_msgs::CameraInfo& info, bool rectified, cv::Size size) {
  const cv::Size calibrated(static_cast<int>(info.width), static_cast<int>(info.height));
  const auto camera = usable_camera(camera_matrix(info, rectified), calibrated, size);
  if (!camera) return {};
  return rectified ? rays_of(*camera) : distorted_rays(info);
}

Plane platform_plane(const PlatformConfig& config, const std_msgs::Header& header,
                     const tf2_ros::Buffer& tf) {
  if (config.platform_frame.empty()) return plane_at(config.platform_distance);
  const Eigen::Isometry3d pose = tf2::transformToEigen(
      tf.lookupTransform(camera_frame_of(config, header), config.platform_frame, header.stamp));
  cv::Matx44d matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix(row, column) = pose(row, column);
  return plane_of(matrix);
}

}  // namespace

std::string camera_frame_of(const PlatformConfig& config, const std_msgs::Header& header) {
  return config.camera_frame.empty() ? header.frame_id : config.camera_frame;
}

Calibration calibrate(const PlatformConfig& config, const sensor_msgs::CameraInfo* info,
                      const std_msgs::Header& header, cv::Size size, const tf2_ros::Buffer& tf) {
  if (config.platform_frame.empty() && config.platform_distance <= 0)
    return {{}, "set platform_frame or platform_distance to get poses in metres"};
  if (camera_frame_of(config, header).empty())
    return {{}, "pictures name no frame_id; let the camera set one, or set camera_frame"};
  if (info == nullptr) return {{}, "no camera_info of this picture's size and frame"};
  try {
    const auto ray = rays(*info, config.rectified, size);
    if (!ray)
      return {{},
              std::string("camera_info is not usable; calibrate the camera (") +
                  (config.rectified ? "P" : "K and D") + " counts)"};
    return {Platform(*ray, platform_plane(config, header, tf)), ""};
  } catch (const std::exception& error) {
    return {{}, std::string("platform: ") + error.what()};
  }
}

}  // namespace mbncc::nodelets
