// SPDX-License-Identifier: BSD-3-Clause
// Corrects lens distortion: converts a raw picture to one with the camera matrix P of camera_info.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <opencv2/core.hpp>
#include <string>

namespace mbncc::nodelets {

/// A rectified picture, or why there is none.
struct Rectified {
  cv::Mat picture;    ///< CV_8UC3
  std::string fault;  ///< message with the remedy

  explicit operator bool() const { return fault.empty(); }
};

class Rectifier {
 public:
  /// `picture` is CV_8UC3. The first picture of a calibration takes longer.
  Rectified rectify(const cv::Mat& picture, const sensor_msgs::CameraInfo& info);

 private:
  void take_over(const sensor_msgs::CameraInfo& info, cv::Size size);

  sensor_msgs::CameraInfo info_;  // calibration of the maps, without its header
  cv::Mat places_, fractions_;    // coordinates in the raw picture, for cv::remap
};

}  // namespace mbncc::nodelets
