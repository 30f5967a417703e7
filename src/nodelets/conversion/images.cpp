// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/images.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "mbncc/image_limits.hpp"
#include "mbncc/label.hpp"

namespace mbncc::nodelets {
namespace {

constexpr std::uint32_t kLargestSide = ImageLimits::kMostSide;  // [px]
constexpr std::uint64_t kMostPixels = ImageLimits::kMostPixels;
constexpr std::size_t kLongestFrame = 255;  // [bytes] longest frame_id
constexpr int kCopy = -1;                   // in place of a colour code: no conversion
constexpr int kFullRange = 65535;           // largest value of 16 bits
constexpr const char* kUnscaled = "16UC1";  // encoding that does not define its range

struct Encoding {
  const char* name;
  int type;        // OpenCV's type of the message's data
  int conversion;  // OpenCV's colour code to bgr
};

// sensor_msgs names a Bayer pattern by its first two rows, OpenCV by the second and third pixel of
// the second row.
constexpr std::array<Encoding, 23> kEncodings{{
    {"mono8", CV_8UC1, cv::COLOR_GRAY2BGR},
    {"8UC1", CV_8UC1, cv::COLOR_GRAY2BGR},
    {"mono16", CV_16UC1, cv::COLOR_GRAY2BGR},
    {kUnscaled, CV_16UC1, cv::COLOR_GRAY2BGR},
    {"bgr8", CV_8UC3, kCopy},
    {"8UC3", CV_8UC3, kCopy},
    {"rgb8", CV_8UC3, cv::COLOR_RGB2BGR},
    {"bgra8", CV_8UC4, cv::COLOR_BGRA2BGR},
    {"rgba8", CV_8UC4, cv::COLOR_RGBA2BGR},
    {"bgr16", CV_16UC3, kCopy},
    {"rgb16", CV_16UC3, cv::COLOR_RGB2BGR},
    {"bgra16", CV_16UC4, cv::COLOR_BGRA2BGR},
    {"rgba16", CV_16UC4, cv::COLOR_RGBA2BGR},
    {"bayer_rggb8", CV_8UC1, cv::COLOR_BayerBG2BGR},
    {"bayer_bggr8", CV_8UC1, cv::COLOR_BayerRG2BGR},
    {"bayer_gbrg8", CV_8UC1, cv::COLOR_BayerGR2BGR},
    {"bayer_grbg8", CV_8UC1, cv::COLOR_BayerGB2BGR},
    {"bayer_rggb16", CV_16UC1, cv::COLOR_BayerBG2BGR},
    {"bayer_bggr16", CV_16UC1, cv::COLOR_BayerRG2BGR},
    {"bayer_gbrg16", CV_16UC1, cv::COLOR_BayerGR2BGR},
    {"bayer_grbg16", CV_16UC1, cv::COLOR_BayerGB2BGR},
    {"yuv422", CV_8UC2, cv::COLOR_YUV2BGR_UYVY},
    {"yuv422_yuy2", CV_8UC2, cv::COLOR_YUV2BGR_YUY2},
}};

const Encoding* find_encoding(const std::string& name) {
  const auto found = std::find_if(kEncodings.begin(), kEncodings.end(),
                                  [&name](const Encoding& known) { return name == known.name; });
  return found == kEncodings.end() ? nullptr : &*found;
}

bool is_yuv(const Encoding& encoding) {
  return encoding.conversion == cv::COLOR_YUV2BGR_UYVY ||
         encoding.conversion == cv::COLOR_YUV2BGR_YUY2;
}

// The first 32 characters of a text from a message, with '?' for those that are not printable.
std::string printable(const std::string& text) {
  std::string shown = text.substr(0, 32);
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return shown;
}

std::string layout_fault(const sensor_msgs::Image& message, const Encoding& encoding) {
  const std::string size = std::to_string(message.width) + " x " + std::to_string(message.height);
  if (message.width < 2 || message.height < 2 || message.width > kLargestSide ||
      message.height > kLargestSide)
    return "an image of " + size + " pixels is not supported; send 2 .. 16384 px per side";
  if (std::uint64_t{message.width} * message.height > kMostPixels)
    return "an image of " + size + " pixels is not supported; send 64 million at most";
  if (message.header.frame_id.size() > kLongestFrame)
    return "a frame_id of " + std::to_string(message.header.frame_id.size()) +
           " bytes is not supported; send 255 at most";
  if (!is_printable(message.header.frame_id))
    return "frame_id '" + printable(message.header.frame_id) +
           "' contains characters that are not printable; correct the driver";
  if (is_yuv(encoding) && message.width % 2 != 0)
    return "a " + message.encoding + " image of odd width " + std::to_string(message.width) +
           " is not supported; send an even width";
  const std::uint64_t row = std::uint64_t{message.width} * CV_ELEM_SIZE(encoding.type);
  if (message.step < row)
    return "step " + std::to_string(message.step) + " is less than a row of " +
           std::to_string(row) + " bytes; correct the driver";
  if (CV_MAT_DEPTH(encoding.type) == CV_16U && message.step % 2 != 0)
    return "step " + std::to_string(message.step) +
           " is odd, but 16-bit pixels need an even step; correct the driver";
  if (message.data.size() != std::uint64_t{message.step} * message.height)
    return "data of " + std::to_string(message.data.size()) + " bytes is not step " +
           std::to_string(message.step) + " x height " + std::to_string(message.height) +
           "; correct the driver";
  return "";
}

cv::Mat view_of(const sensor_msgs::Image& message, const Encoding& encoding) {
  return cv::Mat(static_cast<int>(message.height), static_cast<int>(message.width), encoding.type,
                 const_cast<std::uint8_t*>(message.data.data()), message.step);
}

/// The image with 16-bit values in this machine's byte order, which is little endian.
cv::Mat in_native_order(const cv::Mat& view, bool is_bigendian) {
  if (!is_bigendian || view.depth() != CV_16U) return view;
  const cv::Mat bytes(view.rows, view.cols * view.channels(), CV_8UC2, view.data, view.step);
  cv::Mat swapped(bytes.size(), CV_8UC2);
  constexpr int kSwap[] = {0, 1, 1, 0};
  cv::mixChannels(&bytes, 1, &swapped, 1, kSwap, 2);
  return cv::Mat(view.rows, view.cols, view.type(), swapped.data).clone();
}

cv::Mat to_bgr(const sensor_msgs::Image& message, const Encoding& encoding, int white_level) {
  const cv::Mat view = in_native_order(view_of(message, encoding), message.is_bigendian != 0);
  cv::Mat image;
  if (encoding.conversion == kCopy)
    view.copyTo(image);
  else
    cv::cvtColor(view, image, encoding.conversion);
  const double white = white_level == 0 ? kFullRange : white_level;
  if (image.depth() == CV_16U) image.convertTo(image, CV_8U, 255 / white);
  return image;
}

Decoded unknown_encoding(const std::string& name) {
  std::string known;
  for (const auto& encoding : kEncodings) known += std::string(" ") + encoding.name;
  Decoded refused;
  refused.fault = "encoding '" + printable(name) + "' is not supported; send one of" + known;
  return refused;
}

}  // namespace

Decoded decode_image(const sensor_msgs::Image& message, int white_level) {
  const Encoding* encoding = find_encoding(message.encoding);
  if (encoding == nullptr) return unknown_encoding(message.encoding);
  Decoded decoded;
  decoded.fault = layout_fault(message, *encoding);
  if (message.encoding == kUnscaled && white_level == 0)
    decoded.fault = "encoding '16UC1' does not define its white level; set white_level";
  if (decoded.fault.empty()) decoded.image = to_bgr(message, *encoding, white_level);
  return decoded;
}

Decoded decode_map(const sensor_msgs::Image& message) {
  Decoded decoded;
  const Encoding* encoding = find_encoding(message.encoding);
  if (encoding == nullptr || encoding->type != CV_8UC1 ||
      encoding->conversion != cv::COLOR_GRAY2BGR) {
    decoded.fault = "a mask of encoding '" + printable(message.encoding) +
                    "' is not supported; send mono8 with 255 on the object and 0 elsewhere";
    return decoded;
  }
  decoded.fault = layout_fault(message, *encoding);
  if (decoded.fault.empty()) decoded.image = view_of(message, *encoding) >= 128;
  return decoded;
}

bool is_given(const sensor_msgs::Image& message) {
  return message.width != 0 || message.height != 0 || !message.data.empty() ||
         !message.encoding.empty();
}

sensor_msgs::Image encode_image(const cv::Mat& image, const std_msgs::Header& header) {
  sensor_msgs::Image message;
  message.header = header;
  if (image.empty()) return message;
  CV_Assert(image.type() == CV_8UC3 || image.type() == CV_8UC1);
  const std::size_t row = image.cols * image.elemSize();
  message.height = static_cast<std::uint32_t>(image.rows);
  message.width = static_cast<std::uint32_t>(image.cols);
  message.encoding = image.type() == CV_8UC3 ? "bgr8" : "mono8";
  message.step = static_cast<std::uint32_t>(row);
  message.data.resize(row * image.rows);
  for (int y = 0; y < image.rows; ++y)
    std::memcpy(message.data.data() + row * y, image.ptr(y), row);
  return message;
}

sensor_msgs::CompressedImage encode_jpeg(const cv::Mat& image, const std_msgs::Header& header) {
  sensor_msgs::CompressedImage message;
  message.header = header;
  message.format = "bgr8; jpeg compressed bgr8";
  cv::imencode(".jpg", image, message.data, {cv::IMWRITE_JPEG_QUALITY, 80});
  return message;
}

}  // namespace mbncc::nodelets
