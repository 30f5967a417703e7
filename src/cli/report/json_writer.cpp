// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/json_writer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "mbncc/config/field.hpp"
#include "mbncc/utf8.hpp"

namespace mbncc::cli {
namespace {

std::string escaped(char c) {
  if (c == '"' || c == '\\') return {'\\', c};
  if (static_cast<unsigned char>(c) >= 0x20) return {c};
  char escape[8];
  std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
  return escape;
}

// JSON is UTF-8, but file names are arbitrary bytes: invalid bytes become the replacement
// character.
std::string quoted(std::string_view text) {
  std::string result = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0)
      result += "\\ufffd";
    else if (length == 1)
      result += escaped(text[0]);
    else
      result += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result + '"';
}

}  // namespace

void JsonWriter::separate() {
  if (!after_key_ && !empty_.empty()) {
    if (!empty_.back()) out_ << ", ";
    empty_.back() = false;
  }
  after_key_ = false;
}

JsonWriter& JsonWriter::begin(char bracket) {
  separate();
  out_ << bracket;
  empty_.push_back(true);
  return *this;
}

JsonWriter& JsonWriter::end(char bracket) {
  out_ << bracket;
  empty_.pop_back();
  if (empty_.empty()) out_ << '\n';
  return *this;
}

JsonWriter& JsonWriter::key(const std::string& name) {
  separate();
  out_ << quoted(name) << ": ";
  after_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::raw(const std::string& text) {
  separate();
  out_ << text;
  return *this;
}

JsonWriter& JsonWriter::value(double number) {
  return raw(std::isfinite(number) ? field_text(number) : "null");
}

JsonWriter& JsonWriter::value(const std::string& text) {
  return raw(quoted(text));
}

JsonWriter& JsonWriter::value(const std::vector<std::string>& texts) {
  begin_array();
  for (const auto& text : texts) value(text);
  return end_array();
}

}  // namespace mbncc::cli
