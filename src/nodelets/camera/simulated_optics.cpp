// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/camera/simulated_optics.hpp"

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "nodelets/conversion/camera_model.hpp"

namespace mbncc::nodelets {
namespace {

PinholeCamera pinhole_of(const SimulatedCameraConfig& config) {
  return {config.focal_length, config.focal_length, (config.width - 1) / 2.0 + config.principal_x,
          (config.height - 1) / 2.0 + config.principal_y};
}

sensor_msgs::CameraInfo info_of(const SimulatedCameraConfig& config, const PinholeCamera& camera) {
  if (config.focal_length > 0) {
    sensor_msgs::CameraInfo info = camera_info_of(camera, {config.width, config.height});
    info.D[0] = config.distortion;
    return info;
  }
  sensor_msgs::CameraInfo sizes;
  sizes.width = static_cast<std::uint32_t>(config.width);
  sizes.height = static_cast<std::uint32_t>(config.height);
  return sizes;
}

/// Rotation by the tilt about the x axis.
cv::Matx33d rotation_of(const SimulatedCameraConfig& config) {
  const double angle = config.tilt * CV_PI / 180, c = std::cos(angle), s = std::sin(angle);
  return {1, 0, 0, 0, c, -s, 0, s, c};
}

cv::Mat places_in_drawing(const sensor_msgs::CameraInfo& info, const cv::Matx33d& rotation) {
  const cv::Size size(static_cast<int>(info.width), static_cast<int>(info.height));
  cv::Mat raw(size, CV_32FC2), places;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      raw.at<cv::Vec2f>(y, x) = {static_cast<float>(x), static_cast<float>(y)};
  const cv::Matx33d k(info.K.data());
  cv::undistortPoints(raw.reshape(2, size.area()), places, k, info.D, rotation, k,
                      {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-9});
  return places.reshape(2, size.height);
}

}  // namespace

SimulatedOptics::SimulatedOptics(const SimulatedCameraConfig& config)
    : camera_(pinhole_of(config)), info_(info_of(config, camera_)), rotation_(rotation_of(config)) {
  if (config.distortion == 0 && config.tilt == 0) return;
  if (config.focal_length == 0)
    throw std::invalid_argument("parameters 'distortion' and 'tilt' need a focal_length above 0");
  where_ = places_in_drawing(info_, rotation_);
}

cv::Mat SimulatedOptics::expose(const cv::Mat& drawing) const {
  if (where_.empty()) return drawing;
  cv::Mat raw;
  // Not INTER_CUBIC, because OpenCV's cubic kernel displaces edges by hundredths of a pixel.
  cv::remap(drawing, raw, where_, cv::noArray(), cv::INTER_LANCZOS4, cv::BORDER_REFLECT_101);
  return raw;
}

}  // namespace mbncc::nodelets
