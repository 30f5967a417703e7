// SPDX-License-Identifier: BSD-3-Clause
// A config struct has one list of fields that serves all readers: YAML, tool flags, ROS parameters,
// the table of parameters and the tests. The list is a static member template of the struct,
//   template <class Self, class Visitor> static void fields(Self& self, Visitor&& visit);
// which calls visit(FieldInfo, value) for every field.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace mbncc {

/// The values that a field accepts. Numbers must be in [low, high]; if there are `choices`, texts
/// must match one of them.
struct Allowed {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices;
  bool printable = false;  ///< texts must be printable, see label.hpp

  static Allowed anything() { return {}; }
  static Allowed range(double low, double high) { return {low, high, {}, false}; }
  static Allowed at_least(double low) {
    return range(low, std::numeric_limits<double>::infinity());
  }
  static Allowed one_of(std::vector<std::string> choices) {
    Allowed allowed;
    allowed.choices = std::move(choices);
    return allowed;
  }

  /// Names of tf frames, including "".
  static Allowed frame() {
    Allowed allowed;
    allowed.printable = true;
    return allowed;
  }

  /// "0 .. 1", ">= 0", "fast | polar", "printable" or "any".
  std::string to_string() const;
};

/// Description of a field.
struct FieldInfo {
  std::string name;  ///< key in YAML, on the parameter server and in --set
  Allowed allowed;
  std::string unit;     ///< "px", "s", ...; "" for a plain number
  std::string meaning;  ///< one sentence
};

/// Calls visit(const FieldInfo&, value&) for every field of `config`; value is a bool, int, double
/// or std::string.
template <class Config, class Visitor>
void for_each_field(Config& config, Visitor&& visit) {
  std::remove_const_t<Config>::fields(config, std::forward<Visitor>(visit));
}

/// Throws ConfigError that names the key, the value and the allowed values if `value` violates
/// `info.allowed`.
void check_allowed(const FieldInfo& info, bool value);
void check_allowed(const FieldInfo& info, int value);
void check_allowed(const FieldInfo& info, double value);
void check_allowed(const FieldInfo& info, const std::string& value);

/// Parses `text` into `value`; throws ConfigError that names the key if the value has the wrong
/// type or is not allowed.
void parse_field(const FieldInfo& info, const std::string& text, bool& value);
void parse_field(const FieldInfo& info, const std::string& text, int& value);
void parse_field(const FieldInfo& info, const std::string& text, double& value);
void parse_field(const FieldInfo& info, const std::string& text, std::string& value);

/// Text that parse_field() parses to the same value.
std::string field_text(bool value);
std::string field_text(int value);
std::string field_text(double value);
std::string field_text(const std::string& value);

/// A field with its type erased, for tables, YAML and --set.
struct FieldRow {
  FieldInfo info;
  std::string type;                                ///< "bool", "int", "double" or "string"
  std::string value;                               ///< as text
  std::function<void(const std::string&)> assign;  ///< parse_field() into the struct
};

template <class T>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<T, bool>) return "bool";
  if constexpr (std::is_same_v<T, int>) return "int";
  if constexpr (std::is_same_v<T, double>) return "double";
  return "string";
}

/// All fields of `config`, which must outlive the rows.
template <class Config>
std::vector<FieldRow> field_rows(Config& config) {
  std::vector<FieldRow> rows;
  for_each_field(config, [&rows](const FieldInfo& info, auto& value) {
    using Value = std::decay_t<decltype(value)>;
    rows.push_back({info, type_name<Value>(), field_text(value),
                    [info, &value](const std::string& text) { parse_field(info, text, value); }});
  });
  return rows;
}

/// Sets the row named `key`; throws ConfigError for an unknown key and suggests the nearest known
/// one.
void assign_field(const std::vector<FieldRow>& rows, const std::string& key,
                  const std::string& text);

/// Reads a flat YAML mapping `key: value` from `path` into the rows. Throws FileError for an
/// unreadable file, and ConfigError for a key that is unknown or whose value has the wrong type or
/// is out of range; that key then changes no row.
void load_yaml_file(const std::vector<FieldRow>& rows, const std::string& path);

}  // namespace mbncc
