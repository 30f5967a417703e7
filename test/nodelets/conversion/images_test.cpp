// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/images.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>

namespace mbncc::nodelets {
namespace {

const cv::Vec3b kColour(40, 90, 200);  // bgr

sensor_msgs::Image message_of(const cv::Mat& memory, const std::string& encoding) {
  sensor_msgs::Image message;
  message.width = static_cast<std::uint32_t>(memory.cols);
  message.height = static_cast<std::uint32_t>(memory.rows);
  message.encoding = encoding;
  message.step = static_cast<std::uint32_t>(memory.cols * memory.elemSize());
  message.data.assign(memory.datastart, memory.dataend);
  return message;
}

// An image of one colour as a sensor with a Bayer pattern sees it; `first_rows` is e.g. "rggb".
cv::Mat mosaic(const std::string& first_rows) {
  cv::Mat memory(8, 10, CV_8UC1);
  for (int y = 0; y < memory.rows; ++y)
    for (int x = 0; x < memory.cols; ++x) {
      const char filter = first_rows[2 * (y % 2) + x % 2];
      memory.at<uchar>(y, x) = filter == 'b' ? kColour[0] : filter == 'g' ? kColour[1] : kColour[2];
    }
  return memory;
}

void expect_colour(const cv::Mat& image, const cv::Vec3b& expected, double tolerance) {
  ASSERT_EQ(image.type(), CV_8UC3);
  EXPECT_LE(cv::norm(image.at<cv::Vec3b>(4, 4), expected, cv::NORM_INF), tolerance);
}

TEST(DecodeImage, KeepsColoursOfEveryOrder) {
  cv::Mat bgr(8, 10, CV_8UC3, cv::Scalar(kColour[0], kColour[1], kColour[2])), other;
  expect_colour(decode_image(message_of(bgr, "bgr8")).image, kColour, 0);
  expect_colour(decode_image(message_of(bgr, "8UC3")).image, kColour, 0);
  cv::cvtColor(bgr, other, cv::COLOR_BGR2RGB);
  expect_colour(decode_image(message_of(other, "rgb8")).image, kColour, 0);
  cv::cvtColor(bgr, other, cv::COLOR_BGR2BGRA);
  expect_colour(decode_image(message_of(other, "bgra8")).image, kColour, 0);
  cv::cvtColor(bgr, other, cv::COLOR_BGR2RGBA);
  expect_colour(decode_image(message_of(other, "rgba8")).image, kColour, 0);
}

TEST(DecodeImage, DemosaicsEveryPattern) {
  for (const std::string pattern : {"rggb", "bggr", "gbrg", "grbg"}) {
    SCOPED_TRACE(pattern);
    expect_colour(decode_image(message_of(mosaic(pattern), "bayer_" + pattern + "8")).image,
                  kColour, 1);
  }
}

TEST(DecodeImage, ReadsGreyOfEightAndSixteenBits) {
  const cv::Mat grey(8, 10, CV_8UC1, cv::Scalar(77));
  expect_colour(decode_image(message_of(grey, "mono8")).image, {77, 77, 77}, 0);
  expect_colour(decode_image(message_of(grey, "8UC1")).image, {77, 77, 77}, 0);
  // The value 0x4d12 in both byte orders.
  auto little = message_of(cv::Mat(8, 10, CV_8UC2, cv::Scalar(0x12, 0x4d)), "mono16");
  expect_colour(decode_image(little).image, {0x4d, 0x4d, 0x4d}, 0);
  auto big = message_of(cv::Mat(8, 10, CV_8UC2, cv::Scalar(0x4d, 0x12)), "mono16");
  big.is_bigendian = 1;
  expect_colour(decode_image(big).image, {0x4d, 0x4d, 0x4d}, 0);
}

/// The same image with the bytes of each number swapped.
sensor_msgs::Image swapped(sensor_msgs::Image message) {
  for (std::size_t i = 0; i + 1 < message.data.size(); i += 2)
    std::swap(message.data[i], message.data[i + 1]);
  message.is_bigendian = 1;
  return message;
}

TEST(DecodeImage, SixteenBitsAreScaledByTheWhiteLevel) {
  const cv::Mat grey(8, 10, CV_16UC1, cv::Scalar(2000));
  for (const auto& [white, expected] :
       {std::pair(0, 8), {65535, 8}, {4095, 125}, {2000, 255}, {1000, 255}}) {
    const auto level = static_cast<uchar>(expected);
    const auto message = message_of(grey, "mono16");
    expect_colour(decode_image(message, white).image, {level, level, level}, 0);
    expect_colour(decode_image(swapped(message), white).image, {level, level, level}, 0);
  }
}

TEST(DecodeImage, DecodesSixteenBitsOfEveryOrderAndPattern) {
  const cv::Mat bgr(8, 10, CV_16UC3, cv::Scalar(kColour[0], kColour[1], kColour[2]) * 16);
  cv::Mat other;
  const int white = 255 * 16;
  expect_colour(decode_image(message_of(bgr, "bgr16"), white).image, kColour, 0);
  cv::cvtColor(bgr, other, cv::COLOR_BGR2RGB);
  expect_colour(decode_image(message_of(other, "rgb16"), white).image, kColour, 0);
  cv::cvtColor(bgr, other, cv::COLOR_BGR2BGRA);
  expect_colour(decode_image(message_of(other, "bgra16"), white).image, kColour, 0);
  cv::cvtColor(bgr, other, cv::COLOR_BGR2RGBA);
  expect_colour(decode_image(message_of(other, "rgba16"), white).image, kColour, 0);
  for (const std::string pattern : {"rggb", "bggr", "gbrg", "grbg"}) {
    SCOPED_TRACE(pattern);
    cv::Mat deep;
    mosaic(pattern).convertTo(deep, CV_16UC1, 16);
    const auto message = message_of(deep, "bayer_" + pattern + "16");
    expect_colour(decode_image(message, white).image, kColour, 1);
    expect_colour(decode_image(swapped(message), white).image, kColour, 1);
  }
}

TEST(DecodeImage, SixteenBitsNeedAWhiteLevel) {
  const auto message = message_of(cv::Mat(8, 10, CV_16UC1, cv::Scalar(500)), "16UC1");
  EXPECT_NE(decode_image(message).fault.find("white_level"), std::string::npos);
  expect_colour(decode_image(message, 1000).image, {128, 128, 128}, 0);
}

TEST(DecodeImage, HalfAPixelOfSixteenBitsIsRefused) {
  auto message = message_of(cv::Mat(8, 10, CV_16UC1, cv::Scalar(500)), "mono16");
  message.step += 1;
  message.data.resize(message.step * message.height);
  EXPECT_NE(decode_image(message).fault.find("odd"), std::string::npos);
}

TEST(DecodeMap, OfSixteenBitsIsRefused) {
  EXPECT_FALSE(decode_map(message_of(cv::Mat(8, 10, CV_16UC1, cv::Scalar(500)), "mono16")));
}

TEST(DecodeImage, ReadsPackedYuv) {
  // Studio range: luma 126 of 16..235 without chroma is the grey 128.
  expect_colour(
      decode_image(message_of(cv::Mat(8, 10, CV_8UC2, cv::Scalar(128, 126)), "yuv422")).image,
      {128, 128, 128}, 1);
  expect_colour(
      decode_image(message_of(cv::Mat(8, 10, CV_8UC2, cv::Scalar(126, 128)), "yuv422_yuy2")).image,
      {128, 128, 128}, 1);
}

TEST(DecodeImage, SkipsThePaddingOfRows) {
  cv::Mat padded(8, 16, CV_8UC1, cv::Scalar(255));
  padded.colRange(0, 10).setTo(50);
  auto message = message_of(padded, "mono8");
  message.width = 10;
  const Decoded decoded = decode_image(message);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(cv::norm(decoded.image, cv::Mat(8, 10, CV_8UC3, cv::Scalar::all(50)), cv::NORM_INF), 0);
}

TEST(DecodeImage, OwnsItsMemory) {
  auto message = message_of(cv::Mat(8, 10, CV_8UC3, cv::Scalar::all(9)), "bgr8");
  const Decoded decoded = decode_image(message);
  std::fill(message.data.begin(), message.data.end(), 200);
  expect_colour(decoded.image, {9, 9, 9}, 0);
}

TEST(DecodeImage, NamesAnUnknownEncodingAndTheKnownOnes) {
  for (const std::string encoding : {"32FC1", "rgb32", "", "bayer_rggb12", "BGR8"}) {
    auto message = message_of(cv::Mat(8, 10, CV_8UC3, cv::Scalar::all(9)), encoding);
    const Decoded decoded = decode_image(message);
    EXPECT_FALSE(decoded);
    EXPECT_NE(decoded.fault.find("'" + encoding + "'"), std::string::npos) << decoded.fault;
    EXPECT_NE(decoded.fault.find("yuv422_yuy2"), std::string::npos) << decoded.fault;
  }
}

TEST(DecodeImage, PrintsNoControlCharactersOfAnEncoding) {
  auto message =
      message_of(cv::Mat(8, 10, CV_8UC3), std::string("a\x1b[31m\n") + std::string(9999, 'x'));
  const std::string fault = decode_image(message).fault;
  EXPECT_EQ(fault.find('\x1b'), std::string::npos);
  EXPECT_EQ(fault.find('\n'), std::string::npos);
  EXPECT_LT(fault.size(), 400u);
}

struct Lie {
  const char* what;
  void (*tell)(sensor_msgs::Image&);
};

TEST(DecodeImage, RefusesAnInconsistentLayout) {
  const Lie lies[] = {
      {"no width", [](auto& m) { m.width = 0; }},
      {"no height", [](auto& m) { m.height = 0; }},
      {"huge width", [](auto& m) { m.width = 1u << 31; }},
      {"huge height", [](auto& m) { m.height = 1u << 31; }},
      {"everything huge", [](auto& m) { m.width = m.height = m.step = 0xffffffffu; }},
      {"step of zero", [](auto& m) { m.step = 0; }},
      {"short step", [](auto& m) { m.step -= 1; }},
      {"long step", [](auto& m) { m.step += 1; }},
      {"short data", [](auto& m) { m.data.pop_back(); }},
      {"long data", [](auto& m) { m.data.push_back(0); }},
      {"no data", [](auto& m) { m.data.clear(); }},
      {"wider than its data", [](auto& m) { m.width += 1; }},
      {"higher than its data", [](auto& m) { m.height += 1; }},
      {"size that overflows 32 bits",
       [](auto& m) { m.width = 1, m.height = 16384, m.step = 1u << 30; }},
      {"encoding of more bytes", [](auto& m) { m.encoding = "bgra8"; }},
      {"odd yuv", [](auto& m) { m.encoding = "yuv422", m.width = 9; }},
      {"odd yuy2", [](auto& m) { m.encoding = "yuv422_yuy2", m.width = 9; }},
      {"one column", [](auto& m) { m.width = 1; }},
      {"one row", [](auto& m) { m.height = 1; }},
      {"a side beyond the bound", [](auto& m) { m.width = 16385; }},
      {"more pixels than bearable",
       [](auto& m) {
         m.encoding = "mono8", m.width = m.step = 16384, m.height = 4096;
         m.data.resize(std::size_t{m.step} * m.height);
       }},
      {"width of 2^31 pixels that step hides", [](auto& m) { m.width = 1u << 31, m.step = 0; }},
      {"step and height that overflow to the data's length",
       [](auto& m) { m.step = 1u << 31, m.height = 2, m.data.clear(); }},
      {"all zero", [](auto& m) { m.width = m.height = m.step = 0, m.data.clear(); }},
      {"negative width", [](auto& m) { m.width = static_cast<std::uint32_t>(-10); }},
      {"a byte of data", [](auto& m) { m.data.resize(1); }},
      {"twice the data", [](auto& m) { m.data.resize(2 * m.data.size()); }},
      {"a row less", [](auto& m) { m.data.resize(m.data.size() - m.step); }},
      {"16 bits in 8", [](auto& m) { m.encoding = "mono16", m.step = 10; }},
      {"encoding with a null in it", [](auto& m) { m.encoding = std::string("bgr8\0", 5); }},
      {"encoding of blanks", [](auto& m) { m.encoding = "  "; }},
      {"encoding of a megabyte", [](auto& m) { m.encoding.assign(1 << 20, 'b'); }},
      {"floats", [](auto& m) { m.encoding = "32FC3"; }},
      {"doubles", [](auto& m) { m.encoding = "64FC1"; }},
      {"16-bit colour", [](auto& m) { m.encoding = "bgr16"; }},  // in rows for 8 bits
      {"signed", [](auto& m) { m.encoding = "8SC3"; }},
      {"two channels", [](auto& m) { m.encoding = "8UC2"; }},
      {"12-bit Bayer", [](auto& m) { m.encoding = "bayer_bggr12"; }},
      {"planar yuv", [](auto& m) { m.encoding = "nv21"; }},
      {"jpeg", [](auto& m) { m.encoding = "jpeg"; }},
      {"a frame's name with a line break", [](auto& m) { m.header.frame_id = "camera\n"; }},
      {"a frame's name with an escape", [](auto& m) { m.header.frame_id = "camera\x1b[2J"; }},
      {"a frame's name with a null", [](auto& m) { m.header.frame_id = std::string("c\0m", 3); }},
      {"a frame's name that runs backwards",
       [](auto& m) { m.header.frame_id = "camera\xe2\x80\xae"; }},
      {"a frame's name that is no UTF-8", [](auto& m) { m.header.frame_id = "camera\xff"; }},
      {"a frame's name of a megabyte", [](auto& m) { m.header.frame_id.assign(1 << 20, 'f'); }},
  };
  static_assert(std::size(lies) >= 41);
  for (const auto& lie : lies) {
    auto message = message_of(cv::Mat(8, 10, CV_8UC3, cv::Scalar::all(9)), "bgr8");
    lie.tell(message);
    const Decoded decoded = decode_image(message);
    EXPECT_FALSE(decoded) << lie.what;
    EXPECT_FALSE(decoded.fault.empty()) << lie.what;
  }
}

TEST(DecodeMap, ThresholdsGreyAndRefusesColour) {
  cv::Mat grey(8, 10, CV_8UC1, cv::Scalar(127));
  grey.colRange(5, 10).setTo(128);
  const Decoded decoded = decode_map(message_of(grey, "mono8"));
  ASSERT_TRUE(decoded);
  EXPECT_EQ(cv::countNonZero(decoded.image), 40);
  EXPECT_EQ(cv::countNonZero(decoded.image == 255), 40);
  EXPECT_FALSE(decode_map(message_of(cv::Mat(8, 10, CV_8UC3), "bgr8")));
}

TEST(EncodeImage, ReadsBackBitForBit) {
  cv::Mat image(8, 10, CV_8UC3);
  cv::randu(image, 0, 256);
  const cv::Mat part = image(cv::Rect(2, 1, 5, 4));  // its rows are not contiguous in memory
  const Decoded decoded = decode_image(encode_image(part));
  ASSERT_TRUE(decoded);
  EXPECT_EQ(cv::norm(decoded.image, part, cv::NORM_INF), 0);
}

TEST(EncodeImage, OfAnEmptyImageIsEmpty) {
  EXPECT_FALSE(is_given(encode_image({})));
  EXPECT_TRUE(is_given(encode_image(cv::Mat::zeros(2, 2, CV_8UC1))));
}

}  // namespace
}  // namespace mbncc::nodelets
