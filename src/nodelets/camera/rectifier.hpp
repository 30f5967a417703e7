// SPDX-License-Identifier: BSD-3-Clause
// Corrects lens distortion: converts a raw image to one with the camera matrix P of camera_info.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <opencv2/core.hpp>
#include <string>

namespace mbncc::nodelets {

/// A rectified image, or why there is none.
struct Rectified {
  cv::Mat image;      ///< CV_8UC3
  std::string fault;  ///< message with the remedy

  explicit operator bool() const { return fault.empty(); }
};

class Rectifier {
 public:
  /// `image` is CV_8UC3. The first image of a calibration takes longer.
  Rectified rectify(const cv::Mat& image, const sensor_msgs::CameraInfo& info);

 private:
  void take_over(const sensor_msgs::CameraInfo& info, cv::Size size);

  sensor_msgs::CameraInfo info_;  // calibration of the maps, without its header
  cv::Mat places_, fractions_;    // coordinates in the raw image, for cv::remap
};

}  // namespace mbncc::nodelets
