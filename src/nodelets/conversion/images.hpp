// SPDX-License-Identifier: BSD-3-Clause
// Converts image messages to and from cv::Mat. Encoding, step and length are checked before a
// byte is read, and no message causes an exception.
#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>

#include <opencv2/core.hpp>
#include <string>

namespace mbncc::nodelets {

/// A decoded image, or the reason why it could not be decoded.
struct Decoded {
  cv::Mat image;      ///< owns its memory; empty if refused
  std::string fault;  ///< "" when decoded

  explicit operator bool() const { return !image.empty(); }
};

/// CV_8UC3 bgr from any accepted encoding: mono8 8UC1 8UC3 bgr8 rgb8 bgra8 rgba8 bayer_*8 yuv422
/// yuv422_yuy2, and with 16 bits mono16 16UC1 bgr16 rgb16 bgra16 rgba16 bayer_*16. In 16-bit images
/// `white_level` becomes 255; if it is 0, 65535 becomes 255 and 16UC1 is refused.
Decoded decode_image(const sensor_msgs::Image& message, int white_level = 0);

/// CV_8UC1 map of 0 and 255 from mono8 or 8UC1; values >= 128 count as object.
Decoded decode_map(const sensor_msgs::Image& message);

/// True if a field of a goal or request contains an image.
bool is_given(const sensor_msgs::Image& message);

/// Message of a CV_8UC3 (bgr8) or CV_8UC1 (mono8) image; an empty image gives an empty message.
sensor_msgs::Image encode_image(const cv::Mat& image, const std_msgs::Header& header = {});

/// Message of an image as JPEG, for consoles on a slow network.
sensor_msgs::CompressedImage encode_jpeg(const cv::Mat& image, const std_msgs::Header& header);

}  // namespace mbncc::nodelets
