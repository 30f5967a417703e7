// SPDX-License-Identifier: BSD-3-Clause
// An image message as a peer may send it: arbitrary bytes, or fields that are nearly consistent. It
// must be refused with an error message, or decoded to an image of the stated size.
#include <ros/serialization.h>

#include <cstdlib>
#include <cstring>

#include "fuzz/fuzzer.hpp"
#include "nodelets/conversion/images.hpp"

using namespace mbncc;

namespace {

constexpr const char* kEncodings[] = {"mono8",       "8UC1",        "mono16",      "bgr8",
                                      "8UC3",        "rgb8",        "bgra8",       "rgba8",
                                      "bayer_rggb8", "bayer_bggr8", "bayer_gbrg8", "bayer_grbg8",
                                      "yuv422",      "yuv422_yuy2", "32FC1",       ""};

// roscpp allocates the memory that a length claims before it notices that the message is shorter:
// up to 4 GB. This is a fault of roscpp, so such messages are left out.
bool lengths_fit(const std::string& bytes) {
  std::size_t at = 12;                        // sequence number and stamp
  for (const std::size_t then : {8, 5, 0}) {  // after frame_id, encoding and data
    std::uint32_t length = 0;
    if (at + sizeof length > bytes.size()) return false;
    std::memcpy(&length, bytes.data() + at, sizeof length);
    at += sizeof length + length;
    if (at > bytes.size()) return false;
    at += then;
  }
  return true;
}

// Deserialises the message as roscpp does.
sensor_msgs::Image image_from_bytes(const std::string& bytes) {
  sensor_msgs::Image message;
  std::string copy = bytes;
  ros::serialization::IStream stream(reinterpret_cast<std::uint8_t*>(copy.data()),
                                     static_cast<std::uint32_t>(copy.size()));
  ros::serialization::deserialize(stream, message);
  return message;
}

// Usually a few pixels, sometimes any number.
std::uint32_t length_from(fuzz::Pieces& pieces) {
  const std::uint8_t kind = pieces.byte();
  if (kind < 240) return kind % 40;
  std::uint32_t length = 0;
  const std::string bytes = pieces.text(sizeof length);
  std::memcpy(&length, bytes.data(), bytes.size());
  return length;
}

sensor_msgs::Image image_from_fields(fuzz::Pieces& pieces) {
  sensor_msgs::Image message;
  const std::uint8_t encoding = pieces.byte();
  message.encoding = encoding < 250 ? kEncodings[encoding % 16] : pieces.text(pieces.byte());
  message.width = length_from(pieces);
  message.height = length_from(pieces);
  message.step = length_from(pieces) * (1 + pieces.byte() % 4);
  message.is_bigendian = pieces.byte();
  // The length that the fields imply, sometimes a little more or less.
  const std::uint8_t error = pieces.byte();
  const std::uint64_t wanted = std::uint64_t{message.step} * message.height;
  const std::uint64_t length = wanted + (error > 250 ? error - 250 : 0) - (error == 250 ? 1 : 0);
  const std::string bytes = pieces.rest();
  message.data.assign(bytes.begin(), bytes.end());
  if (length < 1 << 16) message.data.resize(length);
  return message;
}

void decode(const sensor_msgs::Image& message) {
  const nodelets::Decoded image = nodelets::decode_image(message);
  const nodelets::Decoded map = nodelets::decode_map(message);
  for (const auto* decoded : {&image, &map}) {
    if (static_cast<bool>(*decoded) != decoded->fault.empty()) std::abort();
    if (*decoded && decoded->image.size() != cv::Size(message.width, message.height)) std::abort();
  }
  if (image && message.encoding == "yuv422") fuzz::planted_bug(message.width);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Pieces pieces(data, size);
  if (pieces.byte() % 4 != 0) {
    decode(image_from_fields(pieces));
    return 0;
  }
  const std::string bytes = pieces.rest();
  if (!lengths_fit(bytes)) return 0;
  try {
    decode(image_from_bytes(bytes));
  } catch (const ros::serialization::StreamOverrunException&) {
    // roscpp drops such a message
  }
  return 0;
}
