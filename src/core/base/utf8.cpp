// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/utf8.hpp"

namespace mbncc {
namespace {

bool lies_in(char byte, unsigned low, unsigned high) {
  const auto value = static_cast<unsigned char>(byte);
  return value >= low && value <= high;
}

// Number of bytes of a character that starts with this byte; 0 if the byte is invalid.
std::size_t promised_length(char first) {
  if (lies_in(first, 0x00, 0x7f)) return 1;
  if (lies_in(first, 0xc2, 0xdf)) return 2;
  if (lies_in(first, 0xe0, 0xef)) return 3;
  return lies_in(first, 0xf0, 0xf4) ? 4 : 0;
}

// The second byte rules out overlong forms, surrogates, and code points beyond U+10FFFF.
bool may_follow(char first, char second) {
  switch (static_cast<unsigned char>(first)) {
    case 0xe0:
      return lies_in(second, 0xa0, 0xbf);
    case 0xed:
      return lies_in(second, 0x80, 0x9f);
    case 0xf0:
      return lies_in(second, 0x90, 0xbf);
    case 0xf4:
      return lies_in(second, 0x80, 0x8f);
    default:
      return true;
  }
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  const std::size_t length = text.empty() ? 0 : promised_length(text[0]);
  if (length > text.size()) return 0;
  if (length > 1 && !may_follow(text[0], text[1])) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if (!lies_in(text[i], 0x80, 0xbf)) return 0;
  return length;
}

}  // namespace mbncc
