// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/platform_intrinsics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <sstream>

#include "mbncc/error.hpp"
#include "nodelets/conversion/camera_model.hpp"
#include "nodelets/conversion/rays.hpp"

namespace mbncc::nodelets {
namespace {

using sensor_msgs::CameraInfo;

// [px] Largest motion of a pixel. The rounded numbers of a calibration's file move pixels by less
// than a hundredth; at this limit, positions are off by a twentieth of what a grasp allows.
constexpr double kTolerance = 0.1;
constexpr int kPerSide = 9;  // compared pixels along each side of the sensor
constexpr char kRectified[] = "rectified";
constexpr char kRemedy[] =
    "; calibrate the platform again with calibrate_platform and start the cell with the result, or "
    "restore the earlier calibration of the camera";

struct Intrinsics {
  CameraInfo info;
  bool rectified = false;  ///< P counts, otherwise K and D
};

Intrinsics parse(const std::string& text) {
  std::istringstream words(text);
  std::string model;
  int width = 0, height = 0;
  PinholeCamera camera;
  words >> model >> width >> height >> camera.fx >> camera.fy >> camera.cx >> camera.cy;
  bool complete = words && width > 0 && height > 0;
  std::vector<double> distortion;
  for (double number = 0; words >> number;) distortion.push_back(number);
  complete = complete && words.eof();
  if (!complete)
    throw ConfigError("parameter 'platform_intrinsics': value '" + text +
                      "' is not allowed; give what calibrate_platform writes, or nothing");
  Intrinsics intrinsics{camera_info_of(camera, {width, height}), model == kRectified};
  if (intrinsics.rectified) return intrinsics;
  intrinsics.info.distortion_model = model;
  intrinsics.info.D = distortion;
  return intrinsics;
}

bool has_same_numbers(const CameraInfo& a, const CameraInfo& b, bool rectified) {
  if (rectified) return a.P == b.P;
  return a.K == b.K && a.D == b.D && a.distortion_model == b.distortion_model;
}

/// [px] How far a pixel of an undistorted image moves; infinite if it loses or gains its ray.
double motion_of(const cv::Vec3d& then, const cv::Vec3d& now, double focal_length) {
  const bool had_ray = cv::checkRange(then), has_ray = cv::checkRange(now);
  if (had_ray && has_ray) return focal_length * cv::norm(then / then[2] - now / now[2]);
  return had_ray == has_ray ? 0 : std::numeric_limits<double>::infinity();
}

/// Largest motion over the whole sensor.
double largest_motion(const PixelToRay& then, const PixelToRay& now, cv::Size size,
                      double focal_length) {
  double largest = 0;
  for (int row = 0; row < kPerSide; ++row)
    for (int column = 0; column < kPerSide; ++column) {
      const cv::Point2d pixel(column * (size.width - 1.0) / (kPerSide - 1),
                              row * (size.height - 1.0) / (kPerSide - 1));
      largest = std::max(largest, motion_of(then(pixel), now(pixel), focal_length));
    }
  return largest;
}

std::string text_of(double pixels) {
  if (!std::isfinite(pixels)) return "some pixels have a ray in one of them only";
  std::ostringstream text;
  text.precision(2);
  text << "pixels differ by up to " << pixels << " px";
  return text.str();
}

std::string another_camera(const std::string& difference) {
  return "platform: its pose was measured with another calibration of the camera (" + difference +
         ")" + kRemedy;
}

}  // namespace

void check_platform_intrinsics(const std::string& text) {
  if (!text.empty()) parse(text);
}

std::string fault_of_platform_intrinsics(const std::string& text, const CameraInfo& info) {
  if (text.empty()) return "";
  const Intrinsics then = parse(text);
  CameraInfo now = info;
  now.roi = {};
  now.binning_x = now.binning_y = 0;
  const cv::Size size = image_size(then.info);
  if (image_size(now) != size)
    return another_camera("for images of " + std::to_string(size.width) + " x " +
                          std::to_string(size.height));
  const auto rays_then = rays_of(then.info, then.rectified, size);
  const auto rays_now = rays_of(now, then.rectified, size);
  if (!rays_then || !rays_now)
    return another_camera(then.rectified ? "of rectified images" : "of raw images");
  if (has_same_numbers(then.info, now, then.rectified)) return "";
  const double focal_length = then.info.P[0];
  const double motion = largest_motion(*rays_then, *rays_now, size, focal_length);
  return motion <= kTolerance ? "" : another_camera(text_of(motion));
}

}  // namespace mbncc::nodelets
