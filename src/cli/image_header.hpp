// SPDX-License-Identifier: BSD-3-Clause
// The header of a PNG or JPEG file, checked before a decoder allocates memory.
#pragma once

#include <cstdint>
#include <vector>

namespace mbncc::cli {

struct ImageHeader {
  std::uint32_t width = 0;   ///< [px]
  std::uint32_t height = 0;  ///< [px]
  int bits = 0;              ///< per channel
  int orientation = 1;       ///< EXIF orientation: 1 as captured, 2 .. 8 mirrored or rotated
  bool complete = false;     ///< the file contains the whole image
};

/// Throws std::runtime_error with a message if the bytes are neither PNG nor JPEG or end within
/// the header.
ImageHeader read_image_header(const std::vector<std::uint8_t>& bytes);

}  // namespace mbncc::cli
