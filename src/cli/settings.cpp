// SPDX-License-Identifier: BSD-3-Clause
#include "cli/settings.hpp"

#include <algorithm>
#include <exception>
#include <map>

#include "mbncc/error.hpp"

namespace mbncc::cli {
namespace {

std::vector<FieldRow> all_rows(Settings& settings) {
  std::vector<FieldRow> rows;
  const auto append = [&rows](std::vector<FieldRow> more) {
    rows.insert(rows.end(), more.begin(), more.end());
  };
  append(field_rows(settings.matching));
  append(field_rows(settings.learning));
  append(field_rows(settings.camera));
  append(field_rows(settings.rectify));
  append(field_rows(settings.simulated_camera));
  return rows;
}

bool taken(const FieldRow& row, const std::string& text, std::exception_ptr& refusal) {
  try {
    row.assign(text);
    return true;
  } catch (const ConfigError&) {
    if (!refusal) refusal = std::current_exception();
    return false;
  }
}

// Sets every row that accepts the text; rethrows the first error if none does.
void assign_any(const std::vector<FieldRow>& rows, const std::string& text) {
  std::exception_ptr refusal;
  bool any = false;
  for (const auto& row : rows) any = taken(row, text, refusal) || any;
  if (!any) std::rethrow_exception(refusal);
}

// Merges the rows that have the same name.
std::vector<FieldRow> merged(const std::vector<FieldRow>& rows) {
  std::map<std::string, std::vector<FieldRow>> by_name;
  for (const auto& row : rows) by_name[row.info.name].push_back(row);
  std::vector<FieldRow> result;
  for (const auto& [name, same] : by_name) {
    result.push_back(same.front());
    result.back().assign = [same = same](const std::string& text) { assign_any(same, text); };
  }
  return result;
}

// Applies --config and --set to these rows.
void assign_given(const Arguments& arguments, const std::vector<FieldRow>& rows) {
  if (arguments.has("--config")) load_yaml_file(rows, arguments.get("--config"));
  for (const auto& pair : arguments.all("--set")) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos) throw UsageError("--set needs key=value, not '" + pair + "'");
    assign_field(rows, pair.substr(0, equals), pair.substr(equals + 1));
  }
}

// The rows whose names are not yet listed; a nodelet's list repeats those of the core.
std::vector<FieldRow> without(const std::vector<FieldRow>& listed, std::vector<FieldRow> rows) {
  const auto is_listed = [&listed](const FieldRow& row) {
    return std::any_of(listed.begin(), listed.end(),
                       [&row](const FieldRow& other) { return other.info.name == row.info.name; });
  };
  rows.erase(std::remove_if(rows.begin(), rows.end(), is_listed), rows.end());
  return rows;
}

}  // namespace

std::vector<SettingsSection> sections_of(Settings& settings) {
  const auto search = field_rows(settings.search()), lesson = field_rows(settings.lesson());
  const auto platform = field_rows(settings.matching.platform);
  return {{"search (find, learn, matching nodelet)", search},
          {"lesson (learn, learning nodelet)", lesson},
          {"platform (matching and learning nodelet)", platform},
          {"matching nodelet", without(platform, without(search, field_rows(settings.matching)))},
          {"learning nodelet", without(platform, without(lesson, field_rows(settings.learning)))},
          {"camera nodelet", field_rows(settings.camera)},
          {"rectify nodelet", field_rows(settings.rectify)},
          {"simulated camera nodelet", field_rows(settings.simulated_camera)}};
}

std::vector<Option> settings_options() {
  return {{"--config", "FILE.yaml", "parameters as lines `key: value`, see 'mbncc params'"},
          {"--set", "key=value", "one parameter; overrides --config", false, true}};
}

void change_settings(Settings& settings, const Arguments& arguments) {
  assign_given(arguments, merged(all_rows(settings)));
}

Settings settings_from(const Arguments& arguments) {
  Settings settings;
  change_settings(settings, arguments);
  return settings;
}

SimulatedCameraConfig simulated_camera_from(const Arguments& arguments) {
  Settings others;
  SimulatedCameraConfig config;
  const auto own = field_rows(config);
  auto rows = without(own, all_rows(others));
  rows.insert(rows.end(), own.begin(), own.end());
  assign_given(arguments, merged(rows));
  return config;
}

}  // namespace mbncc::cli
