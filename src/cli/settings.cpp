#include "cli/settings.hpp"

#include <algorithm>
#include <set>

namespace mbncc::cli {
namespace {

std::vector<FieldRow> all_rows(Settings& settings) {
  std::vector<FieldRow> rows;
  const auto append = [&rows](std::vector<FieldRow> more) {
    rows.insert(rows.end(), more.begin(), more.end());
  };
  append(field_rows(settings.matching));
  append(field_rows(settings.learning));
  return rows;
}

}  // namespace

std::vector<SettingsSection> sections_of(Settings& settings) {
  std::vector<SettingsSection> sections = {
      {"search (find, learn, matching nodelet)", field_rows(settings.search())},
      {"lesson (learn, learning nodelet)", field_rows(settings.lesson())},
      {"platform (both nodelets)", field_rows(settings.matching.platform)},
      {"matching nodelet", field_rows(settings.matching)},
      {"learning nodelet", field_rows(settings.learning)}};
  // A nodelet's list repeats those of the core, and library_path is in both nodelets.
  std::set<std::string> listed;
  for (auto& section : sections) {
    auto& rows = section.rows;
    rows.erase(
        std::remove_if(rows.begin(), rows.end(),
                       [&listed](const FieldRow& row) { return listed.count(row.info.name) != 0; }),
        rows.end());
    for (const auto& row : rows) listed.insert(row.info.name);
  }
  return sections;
}

std::vector<FieldRow> rows_of(Settings& settings) {
  std::vector<FieldRow> merged;
  for (const auto& row : all_rows(settings)) {
    const auto same = std::find_if(merged.begin(), merged.end(), [&row](const FieldRow& other) {
      return other.info.name == row.info.name;
    });
    if (same == merged.end()) {
      merged.push_back(row);
      continue;
    }
    same->assign = [first = same->assign, second = row.assign](const std::string& text) {
      first(text);
      second(text);
    };
  }
  return merged;
}

std::vector<Option> settings_options() {
  return {{"--config", "FILE.yaml", "parameters as lines `key: value`, see 'mbncc params'"},
          {"--set", "key=value", "one parameter, over those of --config", false, true}};
}

Settings settings_from(const Arguments& arguments) {
  Settings settings;
  const auto rows = rows_of(settings);
  if (arguments.has("--config")) load_yaml_file(rows, arguments.get("--config"));
  for (const auto& pair : arguments.all("--set")) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos) throw UsageError("--set needs key=value, not '" + pair + "'");
    assign_field(rows, pair.substr(0, equals), pair.substr(equals + 1));
  }
  return settings;
}

}  // namespace mbncc::cli
