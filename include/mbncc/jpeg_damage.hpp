// SPDX-License-Identifier: BSD-3-Clause
// Detects damaged JPEG images, of which decoders invent the missing part.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mbncc {

/// The first fault that decoding a JPEG image meets, in libjpeg's words; "" for an intact image and
/// for other formats. The caller must have checked the image's size.
std::string jpeg_damage(const std::vector<std::uint8_t>& bytes);

}  // namespace mbncc
