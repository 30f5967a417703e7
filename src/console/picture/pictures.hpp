// SPDX-License-Identifier: BSD-3-Clause
// Pictures as the console shows them; all of them CV_8UC3 rgb.
#pragma once

#include <sensor_msgs/Image.h>

#include <opencv2/core.hpp>

namespace mbncc::console {

/// Empty when the message is none or of an encoding that cannot be shown.
cv::Mat to_rgb(const sensor_msgs::Image& message);

/// `picture`, shrunk where it is larger than the window shows it.
cv::Mat small(const cv::Mat& picture);

/// The object alone, `map` (mono8) saying which pixels are, on a checkerboard.
cv::Mat on_checkerboard(const cv::Mat& template_image, const sensor_msgs::Image& map);

/// Tints what differs from the picture kept at first.
class ChangeTint {
 public:
  /// The next picture is kept.
  void reset() { first_.release(); }
  cv::Mat tint(const cv::Mat& picture);

 private:
  cv::Mat first_;  // CV_8UC3, smoothed
};

}  // namespace mbncc::console
