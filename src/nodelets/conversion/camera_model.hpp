// SPDX-License-Identifier: BSD-3-Clause
// camera_info, checked for plausibility, in pixels of the received image: its region of interest
// and binning are applied as CameraInfo.msg defines them.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/cell/platform.hpp"

namespace mbncc::nodelets {

/// The camera of raw images, of the models plumb_bob, rational_polynomial or equidistant.
/// rays.cpp, camera/rectifier.cpp, scripts/calibrate_platform and camera_info_fuzz_test.cpp tell
/// them apart as well; docs/interfaces.md names them.
struct Lens {
  PinholeCamera camera;
  std::vector<double> distortion;  ///< as OpenCV takes it; empty: none
  bool is_fisheye = false;         ///< of cv::fisheye, CameraInfo's "equidistant"
};

/// Message if there is no calibration of an image.
constexpr char kNoCameraInfo[] =
    "no camera_info of this image's size and frame has come within max_info_age; compare "
    "its topic, size and frame_id with those of the images";

/// Size of the images that come with the calibration: the region of interest, binned. Empty if
/// the message contradicts itself.
cv::Size image_size(const sensor_msgs::CameraInfo& info);

/// Why the calibration cannot be used for images of `size`, by P if they are `rectified`,
/// otherwise by K and D: one message with a remedy. "" if it can be used.
std::string fault_of_calibration(const sensor_msgs::CameraInfo& info, bool rectified,
                                 cv::Size size);

/// Of a calibration without fault in raw images.
Lens lens_of(const sensor_msgs::CameraInfo& info);

/// Of a calibration without fault in rectified images.
PinholeCamera rectified_camera_of(const sensor_msgs::CameraInfo& info);

/// Rotation of the rectified camera relative to the raw one; the identity if R is empty.
cv::Matx33d rectification_of(const sensor_msgs::CameraInfo& info);

/// Calibration without header of images of `size` without distortion.
sensor_msgs::CameraInfo camera_info_of(const PinholeCamera& camera, cv::Size size);

/// As OpenCV takes it.
cv::Matx33d matrix_of(const PinholeCamera& camera);

}  // namespace mbncc::nodelets
