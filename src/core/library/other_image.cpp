// SPDX-License-Identifier: BSD-3-Clause
#include "library/other_image.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "library/file_io.hpp"
#include "library/object_yaml.hpp"

namespace mbncc::library {
namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20;  // of one photograph
constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kFrame = 12;  // [bytes] of a chunk besides its data: length, type, checksum

std::uint32_t number_at(const std::uint8_t* bytes) {
  return (std::uint32_t{bytes[0]} << 24) | (std::uint32_t{bytes[1]} << 16) |
         (std::uint32_t{bytes[2]} << 8) | bytes[3];
}

// CRC-32 as in the PNG specification, annex D.
std::uint32_t checksum(const std::uint8_t* bytes, std::size_t count) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t i = 0; i < entries.size(); ++i) {
      entries[i] = i;
      for (int bit = 0; bit < 8; ++bit)
        entries[i] = (entries[i] >> 1) ^ ((entries[i] & 1) != 0 ? 0xedb88320 : 0);
    }
    return entries;
  }();
  std::uint32_t sum = 0xffffffff;
  for (std::size_t i = 0; i < count; ++i) sum = table[(sum ^ bytes[i]) & 0xff] ^ (sum >> 8);
  return ~sum;
}

struct Chunk {
  const std::uint8_t* start;  // of the length
  std::size_t length;         // [bytes] of the data

  bool is(const char* type) const { return std::memcmp(start + 4, type, 4) == 0; }
  bool is_intact() const {
    return checksum(start + 4, length + 4) == number_at(start + 8 + length);
  }
  bool describes_an_object() const {
    const std::size_t key = std::strlen(kTextKey) + 1;  // a null byte terminates the keyword
    return (is("tEXt") || is("zTXt") || is("iTXt")) && length >= key &&
           std::memcmp(start + 8, kTextKey, key) == 0;
  }
};

bool holds_another_image(const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() < kSignature.size() ||
      !std::equal(kSignature.begin(), kSignature.end(), bytes.begin()))
    return false;
  for (std::size_t at = kSignature.size(); bytes.size() - at >= kFrame;) {
    const Chunk chunk{&bytes[at], number_at(&bytes[at])};
    if (chunk.length > bytes.size() - at - kFrame || !chunk.is_intact() ||
        chunk.describes_an_object())
      return false;
    if (chunk.is("IEND")) return true;
    at += kFrame + chunk.length;
  }
  return false;
}

}  // namespace

bool is_other_image(const std::string& path) {
  try {
    return holds_another_image(read_regular_file(path, kMostBytes).bytes);
  } catch (const FileError&) {
    return false;
  }
}

}  // namespace mbncc::library
