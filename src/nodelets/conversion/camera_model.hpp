// SPDX-License-Identifier: BSD-3-Clause
// Checks camera_info for plausibility and converts it to pixels of the received image: the region
// of interest and binning are applied as CameraInfo.msg defines them.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/cell/pinhole_camera.hpp"

namespace mbncc::nodelets {

/// The camera of raw images with one of the models plumb_bob, rational_polynomial or equidistant.
/// docs/contributing.md lists what else a new model needs.
struct Lens {
  PinholeCamera camera;
  std::vector<double> distortion;  ///< coefficients in OpenCV's order; empty: none
  bool is_fisheye = false;         ///< model of cv::fisheye, "equidistant" in CameraInfo
};

/// Message if there is no calibration for an image.
constexpr char kNoCameraInfo[] =
    "no camera_info of this image's size and frame was received within max_info_age, or it has "
    "just changed; compare its topic, size, frame_id and stamp with those of the images";

/// Size of the images that the calibration applies to: the region of interest after binning. Empty
/// if the message contradicts itself.
cv::Size image_size(const sensor_msgs::CameraInfo& info);

/// Why the calibration cannot be used for images of `size`, with the remedy; "" if it can be used.
/// Checks P and R if the images are `rectified`, otherwise K, R and D.
std::string fault_of_calibration(const sensor_msgs::CameraInfo& info, bool rectified,
                                 cv::Size size);

/// Lens of the raw images. The calibration must not have a fault.
Lens lens_of(const sensor_msgs::CameraInfo& info);

/// Camera of the rectified images. The calibration must not have a fault.
PinholeCamera rectified_camera_of(const sensor_msgs::CameraInfo& info);

/// Rotation of the rectified camera relative to the raw one; the identity if R is empty.
cv::Matx33d rectification_of(const sensor_msgs::CameraInfo& info);

/// Calibration of images of `size` without distortion; its header is empty.
sensor_msgs::CameraInfo camera_info_of(const PinholeCamera& camera, cv::Size size);

/// Camera matrix of the form that OpenCV uses.
cv::Matx33d matrix_of(const PinholeCamera& camera);

}  // namespace mbncc::nodelets
