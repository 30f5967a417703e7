// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/config/field.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

#include "mbncc/did_you_mean.hpp"
#include "mbncc/error.hpp"
#include "mbncc/label.hpp"

namespace mbncc {
namespace {

[[noreturn]] void refuse(const FieldInfo& info, const std::string& value,
                         const std::string& wanted) {
  throw ConfigError("parameter '" + info.name + "': value '" + value + "' is not allowed; give " +
                    wanted + (info.unit.empty() ? "" : " [" + info.unit + "]"));
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : " | ") + word;
  return text;
}

double number_of(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = std::numeric_limits<double>::quiet_NaN();
  stream >> value;
  return value;
}

// The shortest text that reads back as the same value, with a decimal point in any locale.
std::string number_text(double value) {
  std::ostringstream text;
  for (const int digits : {15, 16, 17}) {
    text.str("");
    text.imbue(std::locale::classic());
    text << std::setprecision(digits) << value;
    if (std::isnan(value) || number_of(text.str()) == value) break;
  }
  return text.str();
}

}  // namespace

std::string Allowed::to_string() const {
  if (!choices.empty()) return joined(choices);
  if (printable) return "printable";
  if (std::isinf(low) && std::isinf(high)) return "any";
  if (std::isinf(high)) return ">= " + number_text(low);
  return number_text(low) + " .. " + number_text(high);
}

void check_allowed(const FieldInfo&, bool) {}

void check_allowed(const FieldInfo& info, double value) {
  if (!(value >= info.allowed.low && value <= info.allowed.high))
    refuse(info, number_text(value), "a number " + info.allowed.to_string());
}

void check_allowed(const FieldInfo& info, int value) {
  if (value < info.allowed.low || value > info.allowed.high)
    refuse(info, std::to_string(value), "an integer " + info.allowed.to_string());
}

void check_allowed(const FieldInfo& info, const std::string& value) {
  const auto& choices = info.allowed.choices;
  if (!choices.empty() && std::find(choices.begin(), choices.end(), value) == choices.end())
    refuse(info, value, "one of " + info.allowed.to_string());
  if (info.allowed.printable && !is_printable(value))
    throw ConfigError("parameter '" + info.name +
                      "' contains characters that are not printable; type it again");
}

void parse_field(const FieldInfo& info, const std::string& text, bool& value) {
  if (text != "true" && text != "false") refuse(info, text, "true or false");
  value = text == "true";
}

void parse_field(const FieldInfo& info, const std::string& text, int& value) {
  int parsed = 0;
  const auto end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, parsed);
  if (text.empty() || read.ec != std::errc() || read.ptr != end)
    refuse(info, text, "an integer " + info.allowed.to_string());
  check_allowed(info, parsed);
  value = parsed;
}

void parse_field(const FieldInfo& info, const std::string& text, double& value) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double parsed = 0;
  // Accepts an int or double that is not followed by anything: "1e3" is a number, "1 m" and "nan"
  // are not.
  if (!(stream >> parsed) || stream.peek() != std::istringstream::traits_type::eof())
    refuse(info, text, "a number " + info.allowed.to_string());
  check_allowed(info, parsed);
  value = parsed;
}

void parse_field(const FieldInfo& info, const std::string& text, std::string& value) {
  check_allowed(info, text);
  value = text;
}

std::string field_text(bool value) {
  return value ? "true" : "false";
}
std::string field_text(int value) {
  return std::to_string(value);
}
std::string field_text(double value) {
  return number_text(value);
}
std::string field_text(const std::string& value) {
  return value;
}

void assign_field(const std::vector<FieldRow>& rows, const std::string& key,
                  const std::string& text) {
  std::vector<std::string> known;
  for (const auto& row : rows) {
    if (row.info.name == key) return row.assign(text);
    known.push_back(row.info.name);
  }
  const std::string guess = did_you_mean(key, known);
  throw ConfigError("parameter '" + key + "' is unknown" + (guess.empty() ? ";" : guess) +
                    " `mbncc params` lists all of them");
}

void load_yaml_file(const std::vector<FieldRow>& rows, const std::string& path) {
  if (!std::filesystem::exists(path)) throw FileError(path, "there is no such file");
  if (std::filesystem::is_directory(path))
    throw FileError(path, "a folder; give a file of lines `key: value`");
  YAML::Node root;
  try {
    root = YAML::LoadFile(path);
  } catch (const YAML::Exception& error) {
    throw FileError(path, std::string("not a readable YAML file: ") + error.what());
  }
  if (!root.IsMap()) throw FileError(path, "expected lines of the form `key: value`");
  for (const auto& entry : root) {
    if (!entry.first.IsScalar())
      throw ConfigError("'" + path + "' has a parameter whose name is not a single word");
    const std::string key = entry.first.Scalar();
    if (!entry.second.IsScalar())
      throw ConfigError("parameter '" + key + "' must be a single value");
    assign_field(rows, key, entry.second.Scalar());
  }
}

}  // namespace mbncc
