// SPDX-License-Identifier: BSD-3-Clause
// Undoes lens distortion: a raw picture becomes one whose rays P of camera_info tells.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <opencv2/core.hpp>
#include <string>

namespace mbncc::nodelets {

/// A rectified picture, or why there is none.
struct Rectified {
  cv::Mat picture;    ///< CV_8UC3
  std::string fault;  ///< one sentence with the remedy

  explicit operator bool() const { return fault.empty(); }
};

class Rectifier {
 public:
  /// `picture` is CV_8UC3. The first picture of a calibration takes longer.
  Rectified rectify(const cv::Mat& picture, const sensor_msgs::CameraInfo& info);

 private:
  void take_over(const sensor_msgs::CameraInfo& info, cv::Size size);

  sensor_msgs::CameraInfo info_;  // that the places are of, without its header
  cv::Mat places_, fractions_;    // in the raw picture, as cv::remap takes them
};

}  // namespace mbncc::nodelets
