// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/camera/simulated_optics.hpp"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace mbncc::nodelets {
namespace {

PinholeCamera pinhole_of(const SimulatedCameraConfig& config) {
  return {config.focal_length, config.focal_length, (config.width - 1) / 2.0 + config.principal_x,
          (config.height - 1) / 2.0 + config.principal_y};
}

sensor_msgs::CameraInfo info_of(const SimulatedCameraConfig& config, const PinholeCamera& camera) {
  sensor_msgs::CameraInfo info;
  info.width = static_cast<std::uint32_t>(config.width);
  info.height = static_cast<std::uint32_t>(config.height);
  if (config.focal_length == 0) return info;
  info.distortion_model = "plumb_bob";
  info.D = {config.distortion, 0, 0, 0, 0};
  info.K = {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {camera.fx, 0, camera.cx, 0, 0, camera.fy, camera.cy, 0, 0, 0, 1, 0};
  return info;
}

cv::Mat undistorted_places(const sensor_msgs::CameraInfo& info) {
  const cv::Size size(static_cast<int>(info.width), static_cast<int>(info.height));
  cv::Mat raw(size, CV_32FC2), places;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      raw.at<cv::Vec2f>(y, x) = {static_cast<float>(x), static_cast<float>(y)};
  const cv::Matx33d k(info.K.data());
  cv::undistortPoints(raw.reshape(2, size.area()), places, k, info.D, cv::noArray(), k,
                      {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-9});
  return places.reshape(2, size.height);
}

}  // namespace

SimulatedOptics::SimulatedOptics(const SimulatedCameraConfig& config)
    : camera_(pinhole_of(config)), info_(info_of(config, camera_)) {
  if (config.distortion == 0) return;
  if (config.focal_length == 0)
    throw std::invalid_argument("parameter 'distortion' needs a focal_length above 0");
  where_ = undistorted_places(info_);
}

cv::Mat SimulatedOptics::distort(const cv::Mat& undistorted) const {
  if (where_.empty()) return undistorted;
  cv::Mat raw;
  cv::remap(undistorted, raw, where_, cv::noArray(), cv::INTER_CUBIC, cv::BORDER_REFLECT_101);
  return raw;
}

}  // namespace mbncc::nodelets
