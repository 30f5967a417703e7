// SPDX-License-Identifier: BSD-3-Clause
// Writes one JSON document incrementally, on one line.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace mbncc::cli {

class JsonWriter {
 public:
  explicit JsonWriter(std::ostream& out) : out_(out) {}

  JsonWriter& begin_object() { return begin('{'); }
  JsonWriter& end_object() { return end('}'); }
  JsonWriter& begin_array() { return begin('['); }
  JsonWriter& end_array() { return end(']'); }

  /// Sets the name of the next value within an object.
  JsonWriter& key(const std::string& name);

  JsonWriter& value(double number);  ///< null for NaN and infinities
  JsonWriter& value(int number) { return raw(std::to_string(number)); }
  JsonWriter& value(std::uint32_t number) { return raw(std::to_string(number)); }
  JsonWriter& value(bool truth) { return raw(truth ? "true" : "false"); }
  /// Bytes that are not valid UTF-8 become U+FFFD.
  JsonWriter& value(const std::string& text);
  JsonWriter& value(const char* text) { return value(std::string(text)); }
  JsonWriter& value(const std::vector<std::string>& texts);

  template <class Value>
  JsonWriter& member(const std::string& name, const Value& content) {
    return key(name).value(content);
  }

 private:
  JsonWriter& begin(char bracket);
  JsonWriter& end(char bracket);
  JsonWriter& raw(const std::string& text);
  void separate();

  std::ostream& out_;
  std::vector<bool> empty_;  // per open bracket: nothing has been written in it yet
  bool after_key_ = false;
};

}  // namespace mbncc::cli
