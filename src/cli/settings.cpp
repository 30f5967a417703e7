#include "cli/settings.hpp"

#include <algorithm>

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

// The rows whose names are not among the listed ones: a nodelet's list repeats those of the core.
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
