// SPDX-License-Identifier: BSD-3-Clause
// What a PNG or JPEG file says of itself, judged before a decoder allocates anything for it.
#pragma once

#include <cstdint>
#include <vector>

namespace mbncc::cli {

struct PictureHeader {
  std::uint32_t width = 0;   ///< [px]
  std::uint32_t height = 0;  ///< [px]
  int bits = 0;              ///< per channel
  int orientation = 1;       ///< EXIF's: 1 as the sensor saw it, 2 .. 8 to be mirrored or turned
  bool complete = false;     ///< the end of the picture is there
};

/// Throws std::runtime_error with a sentence when the bytes are neither PNG nor JPEG or end within
/// the header.
PictureHeader read_picture_header(const std::vector<std::uint8_t>& bytes);

}  // namespace mbncc::cli
