#include "mbncc/label.hpp"

namespace mbncc {
namespace {

constexpr std::size_t kLongest = 200;  // [bytes]

// Printable text: no control characters, and every byte part of a well-formed UTF-8 sequence.
bool is_printable_utf8(const std::string& text) {
  int continuing = 0;
  for (const unsigned char c : text) {
    if ((c >= 0x80 && c < 0xc0) != (continuing > 0)) return false;
    if (continuing > 0) {
      --continuing;
      continue;
    }
    if (c < 0x20 || c == 0x7f || c == 0xc0 || c == 0xc1 || c > 0xf4) return false;
    continuing = c < 0x80 ? 0 : c < 0xe0 ? 1 : c < 0xf0 ? 2 : 3;
  }
  return continuing == 0;
}

}  // namespace

bool is_valid_label(const std::string& label) {
  return label.size() <= kLongest && is_printable_utf8(label);
}

}  // namespace mbncc
