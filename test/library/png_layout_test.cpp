// SPDX-License-Identifier: BSD-3-Clause
// PNG files whose chunks are valid individually, but which are not objects as a whole.
#include <gtest/gtest.h>

#include <algorithm>

#include "library/models.hpp"
#include "library/png_codec.hpp"
#include "mbncc/error.hpp"
#include "mbncc/library/object_file.hpp"

namespace mbncc::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint32_t crc_of(const Bytes& bytes) {
  std::uint32_t crc = ~0u;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1)));
  }
  return ~crc;
}

void append_number(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

struct Chunk {
  std::string type;
  Bytes data;
};

class PngLayout : public testing::Test {
 protected:
  /// Chunks of a valid object: IHDR, iTXt, IDAT, IEND.
  static std::vector<Chunk> chunks() {
    const Bytes bytes = encode_object(random_model(1, "wrench", 20));
    std::vector<Chunk> all;
    for (std::size_t at = 8; at < bytes.size();) {
      const std::size_t length =
          bytes[at] << 24 | bytes[at + 1] << 16 | bytes[at + 2] << 8 | bytes[at + 3];
      const auto type = bytes.begin() + static_cast<std::ptrdiff_t>(at) + 4;
      all.push_back({{type, type + 4}, {type + 4, type + 4 + static_cast<std::ptrdiff_t>(length)}});
      at += 12 + length;
    }
    return all;
  }

  static Chunk& chunk(std::vector<Chunk>& all, const std::string& type) {
    return *std::find_if(all.begin(), all.end(),
                         [&](const Chunk& one) { return one.type == type; });
  }

  static Bytes file_of(const std::vector<Chunk>& all) {
    Bytes bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    for (const Chunk& chunk : all) {
      append_number(bytes, static_cast<std::uint32_t>(chunk.data.size()));
      Bytes checked(chunk.type.begin(), chunk.type.end());
      checked.insert(checked.end(), chunk.data.begin(), chunk.data.end());
      bytes.insert(bytes.end(), checked.begin(), checked.end());
      append_number(bytes, crc_of(checked));
    }
    return bytes;
  }

  /// Why the file is refused; "" if it is accepted.
  static std::string fault_of(const Bytes& bytes) {
    try {
      decode_object(bytes, "/library/wrench.png");
      return "";
    } catch (const FileError& error) {
      return error.reason();
    }
  }

  static void expect_refused(const Bytes& bytes, const std::string& words) {
    const std::string fault = fault_of(bytes);
    EXPECT_NE(fault.find(words), std::string::npos) << fault;
  }
};

TEST_F(PngLayout, AnUnchangedFileIsAccepted) {
  EXPECT_EQ(fault_of(file_of(chunks())), "");
}

TEST_F(PngLayout, DataAfterTheImageIsRefused) {
  Bytes bytes = file_of(chunks());
  bytes.push_back(0);
  expect_refused(bytes, "bytes after the image's end");
}

TEST_F(PngLayout, ExactlyOneDescriptionIsRequired) {
  auto all = chunks();
  const Chunk text = chunk(all, "iTXt");
  all.insert(all.begin() + 1, text);
  expect_refused(file_of(all), "text chunk");
  all.erase(all.begin() + 1, all.begin() + 3);
  expect_refused(file_of(all), "text chunk");
}

TEST_F(PngLayout, TextLengthIsLimited) {
  auto all = chunks();
  Bytes& text = chunk(all, "iTXt").data;
  text.insert(text.end(), library::PngLimits::kMaxText, '\n');
  expect_refused(file_of(all), "too long");
}

TEST_F(PngLayout, PixelCountIsCheckedBeforeReading) {
  for (const auto& [width, height] :
       {std::pair(8192, 1025), std::pair(2896, 2897), std::pair(129, 65500)}) {
    auto all = chunks();
    Bytes header;
    append_number(header, static_cast<std::uint32_t>(width));
    append_number(header, static_cast<std::uint32_t>(height));
    std::copy(header.begin(), header.end(), chunk(all, "IHDR").data.begin());
    expect_refused(file_of(all), "too large");
  }
}

TEST_F(PngLayout, OnlyNonInterlacedEightBitRgbaIsAccepted) {
  constexpr std::size_t kDepth = 8, kColourType = 9, kInterlace = 12;
  for (const auto& [at, value] : {std::pair(kDepth, 16), std::pair(kColourType, 2),
                                  std::pair(kColourType, 0), std::pair(kInterlace, 1)}) {
    auto all = chunks();
    chunk(all, "IHDR").data[at] = static_cast<std::uint8_t>(value);
    expect_refused(file_of(all), "not an 8-bit RGBA image without interlacing");
  }
}

}  // namespace
}  // namespace mbncc::test
