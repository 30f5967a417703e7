#include "cli/json_writer.hpp"

#include <cmath>
#include <cstdio>

#include "mbncc/config/field.hpp"

namespace mbncc::cli {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
      result += escape;
    } else {
      result += c;
    }
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
