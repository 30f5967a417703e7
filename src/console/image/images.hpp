// SPDX-License-Identifier: BSD-3-Clause
// Images for display in the console, all CV_8UC3 rgb.
#pragma once

#include <sensor_msgs/Image.h>

#include <opencv2/core.hpp>

namespace mbncc::console {

/// Empty if the message is empty or has an unsupported encoding. For 16-bit images, `white_level`
/// is mapped to 255; with 0, 65535 is, and 16UC1 is unsupported.
cv::Mat to_rgb(const sensor_msgs::Image& message, int white_level = 0);

/// `image`, scaled down if it is larger than the display needs.
cv::Mat small(const cv::Mat& image);

/// The object's pixels, given by `map` (mono8), on a checkerboard.
cv::Mat on_checkerboard(const cv::Mat& template_image, const sensor_msgs::Image& map);

/// Tints the differences to a stored first image.
class ChangeTint {
 public:
  /// The next image is stored as the first one.
  void reset() { first_.release(); }
  cv::Mat tint(const cv::Mat& image);

 private:
  cv::Mat first_;  // CV_8UC3, smoothed
};

}  // namespace mbncc::console
