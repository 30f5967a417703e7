// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/label.hpp"

#include <algorithm>
#include <iterator>

#include "mbncc/utf8.hpp"

namespace mbncc {
namespace {

constexpr std::size_t kLongest = 200;  // [bytes]

struct Range {
  char32_t first, last;
};

// Unicode 15: general category Cc, Bidi_Control, and the separators of lines and paragraphs.
constexpr Range kUnprintable[] = {{0x00, 0x1f},     {0x7f, 0x9f},     {0x61c, 0x61c},
                                  {0x200e, 0x200f}, {0x2028, 0x202e}, {0x2066, 0x2069}};

// Code point encoded by the UTF-8 bytes of one character.
char32_t code_point(std::string_view bytes) {
  constexpr unsigned kFirstBits[] = {0, 0x7f, 0x1f, 0x0f, 0x07};
  char32_t code = static_cast<unsigned char>(bytes[0]) & kFirstBits[bytes.size()];
  for (const char byte : bytes.substr(1))
    code = code << 6 | (static_cast<unsigned char>(byte) & 0x3f);
  return code;
}

bool is_unprintable(char32_t code) {
  return std::any_of(std::begin(kUnprintable), std::end(kUnprintable), [code](const Range& range) {
    return code >= range.first && code <= range.last;
  });
}

}  // namespace

bool is_printable(const std::string& text) {
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t length = utf8_length(rest);
    if (length == 0 || is_unprintable(code_point(rest.substr(0, length)))) return false;
    rest.remove_prefix(length);
  }
  return true;
}

bool is_valid_label(const std::string& label) {
  return label.size() <= kLongest && is_printable(label);
}

}  // namespace mbncc
