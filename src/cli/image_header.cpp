// SPDX-License-Identifier: BSD-3-Clause
#include "cli/image_header.hpp"

#include <algorithm>
#include <stdexcept>

namespace mbncc::cli {
namespace {

constexpr std::uint8_t kPngSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::uint8_t kPngEnd[] = {'I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82};

// JPEG markers (ITU-T T.81, table B.1).
constexpr std::uint8_t kMarker = 0xff, kStartOfImage = 0xd8, kEndOfImage = 0xd9;
constexpr std::uint8_t kFirstRestart = 0xd0, kTemporary = 0x01, kExif = 0xe1;

class Reader {
 public:
  explicit Reader(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  bool at_end() const { return position_ >= bytes_.size(); }
  std::size_t position() const { return position_; }
  void seek(std::size_t position) { position_ = position; }

  /// Reads a big-endian number of `count` bytes.
  std::uint32_t number(int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i) {
      if (at_end()) throw std::runtime_error("the file is truncated");
      value = value << 8 | bytes_[position_++];
    }
    return value;
  }

 private:
  const std::vector<std::uint8_t>& bytes_;
  std::size_t position_ = 0;
};

// Orientation in the first directory of EXIF data (TIFF 6.0) in the range [begin, end) of `bytes`;
// 1 if there is none.
int orientation_in(const std::vector<std::uint8_t>& bytes, std::size_t begin, std::size_t end) {
  constexpr std::uint32_t kOrientation = 0x0112, kEntry = 12;
  end = std::min(end, bytes.size());
  if (begin + 8 > end) return 1;
  const bool little = bytes[begin] == 'I';
  const auto number = [&](std::size_t at, int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count && begin + at + i < end; ++i)
      value |= std::uint32_t{bytes[begin + at + i]} << 8 * (little ? i : count - 1 - i);
    return value;
  };
  const std::size_t directory = number(4, 4);
  const std::size_t entries = number(directory, 2);
  for (std::size_t i = 0; i < entries && begin + directory + kEntry * i < end; ++i) {
    const std::size_t entry = directory + 2 + kEntry * i;
    const std::uint32_t value = number(entry + 8, 2);
    if (number(entry, 2) == kOrientation)
      return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

// Reads the orientation from the chunk eXIf, which precedes the end of the pixel data.
int png_orientation(const std::vector<std::uint8_t>& bytes) {
  constexpr std::uint8_t kName[] = {'e', 'X', 'I', 'f'};
  constexpr std::size_t kFrame = 12;  // [bytes] of a chunk besides its data: length, name, checksum
  Reader reader(bytes);
  for (std::size_t chunk = sizeof kPngSignature; chunk + kFrame <= bytes.size();) {
    reader.seek(chunk);
    const std::size_t length = reader.number(4);
    const auto name = bytes.begin() + static_cast<std::ptrdiff_t>(chunk + 4);
    if (std::equal(std::begin(kName), std::end(kName), name))
      return orientation_in(bytes, chunk + 8, chunk + 8 + length);
    chunk += kFrame + length;
  }
  return 1;
}

// Reads the orientation from an APP1 segment; 1 if it contains none.
int jpeg_orientation(const std::vector<std::uint8_t>& bytes, std::size_t begin, std::size_t end) {
  constexpr std::uint8_t kName[] = {'E', 'x', 'i', 'f', 0, 0};
  if (end > bytes.size() || begin + sizeof kName > end) return 1;
  const auto name = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
  if (!std::equal(std::begin(kName), std::end(kName), name)) return 1;
  return orientation_in(bytes, begin + sizeof kName, end);
}

ImageHeader png_header(const std::vector<std::uint8_t>& bytes) {
  Reader reader(bytes);
  reader.seek(16);  // skips the signature, and length and name of the first chunk, IHDR
  ImageHeader header;
  header.width = reader.number(4);
  header.height = reader.number(4);
  header.bits = static_cast<int>(reader.number(1));
  header.complete = std::search(bytes.begin(), bytes.end(), std::begin(kPngEnd),
                                std::end(kPngEnd)) != bytes.end();
  header.orientation = png_orientation(bytes);
  return header;
}

bool is_frame(std::uint8_t marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

bool stands_alone(std::uint8_t marker) {
  return marker == kTemporary || (marker >= kFirstRestart && marker <= kStartOfImage);
}

// Advances to the next marker; within a scan, 0xff 0x00 is a data byte.
std::uint8_t next_marker(Reader& reader) {
  while (!reader.at_end()) {
    if (reader.number(1) != kMarker) continue;
    std::uint32_t code = kMarker;
    while (code == kMarker && !reader.at_end()) code = reader.number(1);
    if (code != 0 && code != kMarker) return static_cast<std::uint8_t>(code);
  }
  return 0;
}

ImageHeader jpeg_header(const std::vector<std::uint8_t>& bytes) {
  Reader reader(bytes);
  ImageHeader header;
  while (const std::uint8_t marker = next_marker(reader)) {
    if (marker == kEndOfImage) {
      header.complete = header.bits != 0;
      break;
    }
    if (stands_alone(marker)) continue;
    const std::size_t start = reader.position();
    const std::uint32_t length = reader.number(2);
    if (is_frame(marker)) {
      header.bits = static_cast<int>(reader.number(1));
      header.height = reader.number(2);
      header.width = reader.number(2);
    }
    if (marker == kExif && header.orientation == 1)
      header.orientation = jpeg_orientation(bytes, start + 2, start + length);
    reader.seek(start + length);
  }
  return header;
}

}  // namespace

ImageHeader read_image_header(const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() > sizeof kPngSignature &&
      std::equal(std::begin(kPngSignature), std::end(kPngSignature), bytes.begin()))
    return png_header(bytes);
  if (bytes.size() > 2 && bytes[0] == kMarker && bytes[1] == kStartOfImage)
    return jpeg_header(bytes);
  throw std::runtime_error("neither a PNG nor a JPEG image; convert it to PNG");
}

}  // namespace mbncc::cli
