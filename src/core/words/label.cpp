#include "mbncc/label.hpp"

#include "mbncc/utf8.hpp"

namespace mbncc {
namespace {

constexpr std::size_t kLongest = 200;  // [bytes]

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

}  // namespace

bool is_valid_label(const std::string& label) {
  if (label.size() > kLongest) return false;
  std::string_view rest = label;
  while (!rest.empty()) {
    const std::size_t length = utf8_length(rest);
    if (length == 0 || is_control(rest[0])) return false;
    rest.remove_prefix(length);
  }
  return true;
}

}  // namespace mbncc
