// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/camera_model.hpp"

#include <sensor_msgs/distortion_models.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace mbncc::nodelets {
namespace {

namespace models = sensor_msgs::distortion_models;
using sensor_msgs::CameraInfo;

constexpr std::uint32_t kLongestSide = 65536;  // [px] largest side of a sensor
constexpr double kRotationTolerance = 1e-3;    // largest error of a rotation matrix
constexpr double kIdentityTolerance = 1e-6;    // largest difference to the identity
constexpr double kNoBaseline = 1e-6;           // [px m] largest last column of P that counts as 0
constexpr char kRemedy[] = "; calibrate the camera";

/// The pixels of the sensor that form an image.
struct Window {
  cv::Rect region;   // [px] of the sensor
  cv::Size binning;  // binning factors
  cv::Size image;    // [px] of the image
};

std::optional<Window> window_of(const CameraInfo& info) {
  const auto is_side = [](std::uint32_t side) { return side > 0 && side <= kLongestSide; };
  if (!is_side(info.width) || !is_side(info.height)) return {};
  const auto& roi = info.roi;
  const bool whole = roi.x_offset == 0 && roi.y_offset == 0 && roi.width == 0 && roi.height == 0;
  const std::uint32_t width = whole ? info.width : roi.width;
  const std::uint32_t height = whole ? info.height : roi.height;
  const bool inside = width > 0 && height > 0 && width <= info.width && height <= info.height &&
                      roi.x_offset <= info.width - width && roi.y_offset <= info.height - height;
  const std::uint32_t binning_x = std::max(1u, info.binning_x);
  const std::uint32_t binning_y = std::max(1u, info.binning_y);
  if (!inside || binning_x > width || binning_y > height) return {};
  const auto number = [](std::uint32_t value) { return static_cast<int>(value); };
  return Window{{number(roi.x_offset), number(roi.y_offset), number(width), number(height)},
                {number(binning_x), number(binning_y)},
                {number(width / binning_x), number(height / binning_y)}};
}

cv::Matx33d k_of(const CameraInfo& info) {
  return cv::Matx33d(info.K.data());
}

/// The left 3 x 3 part of P.
cv::Matx33d p_of(const CameraInfo& info) {
  const auto& p = info.P;
  return {p[0], p[1], p[2], p[4], p[5], p[6], p[8], p[9], p[10]};
}

/// Converts a camera matrix from pixels of the sensor to pixels of the image. The centre of a
/// binned pixel is the centre of its sensor pixels.
PinholeCamera image_camera_of(const Window& window, const cv::Matx33d& matrix) {
  const double x = window.binning.width, y = window.binning.height;
  return {matrix(0, 0) / x, matrix(1, 1) / y, (matrix(0, 2) - window.region.x - (x - 1) / 2) / x,
          (matrix(1, 2) - window.region.y - (y - 1) / 2) / y};
}

bool is_empty(const cv::Matx33d& matrix) {
  return std::all_of(matrix.val, matrix.val + 9, [](double value) { return value == 0; });
}

/// Compares each entry, so that a value that is not finite counts as a difference.
bool is_close(const cv::Matx33d& a, const cv::Matx33d& b, double tolerance) {
  for (int i = 0; i < 9; ++i)
    if (!(std::abs(a.val[i] - b.val[i]) <= tolerance)) return false;
  return true;
}

bool is_rotation(const cv::Matx33d& matrix) {
  return is_close(matrix * matrix.t(), cv::Matx33d::eye(), kRotationTolerance) &&
         cv::determinant(matrix) > 0;
}

bool is_undistorted(const CameraInfo& info) {
  // A fisheye's images are distorted even with zero coefficients.
  return info.distortion_model != models::EQUIDISTANT &&
         std::all_of(info.D.begin(), info.D.end(), [](double value) { return value == 0; });
}

std::string fault_of_distortion(const CameraInfo& info) {
  const std::string& model = info.distortion_model;
  const std::size_t count = info.D.size();
  if (is_undistorted(info)) return "";
  std::vector<std::size_t> counts;
  if (model == models::PLUMB_BOB) counts = {5, 4};
  if (model == models::RATIONAL_POLYNOMIAL) counts = {8};
  if (model == models::EQUIDISTANT) counts = {4};
  if (counts.empty())
    return "camera_info's distortion_model is not plumb_bob, rational_polynomial or equidistant; "
           "calibrate with one of them, or give rectified images";
  if (std::find(counts.begin(), counts.end(), count) == counts.end())
    return "camera_info: D holds " + std::to_string(count) + " numbers, but " + model + " has " +
           std::to_string(counts.front()) + kRemedy;
  if (!std::all_of(info.D.begin(), info.D.end(), [](double d) { return std::isfinite(d); }))
    return std::string("camera_info: a number of D is not finite") + kRemedy;
  return "";
}

std::string fault_of_raw(const CameraInfo& info, cv::Size sensor) {
  const std::string fault = fault_of_camera(k_of(info), sensor);
  if (!fault.empty()) return "camera_info: in K " + fault + kRemedy;
  if (!is_close(rectification_of(info), cv::Matx33d::eye(), kIdentityTolerance))
    return "camera_info: R rotates the images, as for a stereo pair; use rectified images";
  return fault_of_distortion(info);
}

std::string fault_of_rectified(const CameraInfo& info, cv::Size sensor) {
  const std::string fault = fault_of_camera(p_of(info), sensor);
  if (!fault.empty()) return "camera_info: in P " + fault + kRemedy;
  if (!is_rotation(rectification_of(info)))
    return std::string("camera_info: R is not a rotation") + kRemedy;
  for (const int i : {3, 7, 11})
    if (!(std::abs(info.P[static_cast<std::size_t>(i)]) <= kNoBaseline))
      return "camera_info: P belongs to the second camera of a stereo pair; use images of the "
             "first camera, or raw images";
  return "";
}

std::string text(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

}  // namespace

cv::Size image_size(const CameraInfo& info) {
  const auto window = window_of(info);
  return window ? window->image : cv::Size();
}

std::string fault_of_calibration(const CameraInfo& info, bool rectified, cv::Size size) {
  const auto window = window_of(info);
  if (!window)
    return "camera_info: width, height, roi and binning contradict each other; check the driver";
  if (window->image != size)
    return "camera_info is for images of " + text(window->image) + ", but the image is " +
           text(size) + "; calibrate the camera at this size";
  const cv::Size sensor(static_cast<int>(info.width), static_cast<int>(info.height));
  return rectified ? fault_of_rectified(info, sensor) : fault_of_raw(info, sensor);
}

Lens lens_of(const CameraInfo& info) {
  Lens lens;
  lens.camera = image_camera_of(*window_of(info), k_of(info));
  lens.is_fisheye = info.distortion_model == models::EQUIDISTANT;
  if (!is_undistorted(info)) lens.distortion = info.D;
  return lens;
}

PinholeCamera rectified_camera_of(const CameraInfo& info) {
  return image_camera_of(*window_of(info), p_of(info));
}

cv::Matx33d rectification_of(const CameraInfo& info) {
  const cv::Matx33d r(info.R.data());
  return is_empty(r) ? cv::Matx33d::eye() : r;
}

CameraInfo camera_info_of(const PinholeCamera& camera, cv::Size size) {
  CameraInfo info;
  info.width = static_cast<std::uint32_t>(size.width);
  info.height = static_cast<std::uint32_t>(size.height);
  info.distortion_model = models::PLUMB_BOB;
  info.D = {0, 0, 0, 0, 0};
  info.K = {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {camera.fx, 0, camera.cx, 0, 0, camera.fy, camera.cy, 0, 0, 0, 1, 0};
  return info;
}

cv::Matx33d matrix_of(const PinholeCamera& camera) {
  return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

}  // namespace mbncc::nodelets
