// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/object_name.hpp"

#include <algorithm>
#include <cstddef>

namespace mbncc::console {
namespace {

constexpr std::size_t kLongest = 64;

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

TypedName usable_name(const std::string& typed) {
  TypedName result;
  bool replaced = false, left_out = false;
  for (const char c : typed) {
    const bool gap = c == ' ' || c == '-';
    if (gap || c == '_' || is_letter(c) || is_digit(c)) {
      if (result.name.empty() && !is_letter(c)) {
        left_out = true;
        continue;
      }
      replaced |= gap;
      result.name += gap ? '_' : c;
    } else {
      left_out = true;
    }
  }
  if (result.name.size() > kLongest) {
    result.name.resize(kLongest);
    result.complaint = "A name has at most 64 characters.";
  } else if (left_out) {
    result.complaint =
        "A name begins with a letter and has only letters a to z, digits and _; the rest was left "
        "out.";
  } else if (replaced) {
    result.complaint = "A name has no spaces; they were replaced by _.";
  }
  return result;
}

std::string free_name(const std::string& name, const std::vector<std::string>& taken) {
  for (int number = 2;; ++number) {
    const std::string tail = "_" + std::to_string(number);
    const std::string free = name.substr(0, kLongest - tail.size()) + tail;
    if (std::find(taken.begin(), taken.end(), free) == taken.end()) return free;
  }
}

}  // namespace mbncc::console
