// SPDX-License-Identifier: BSD-3-Clause
// Every YAML file in config/ lists every field of its struct with its default and its range, and
// nothing else.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "mbncc/config/camera_config.hpp"
#include "mbncc/config/field.hpp"
#include "mbncc/config/learning_node_config.hpp"
#include "mbncc/config/matching_node_config.hpp"
#include "mbncc/config/rectify_config.hpp"
#include "mbncc/config/simulated_camera_config.hpp"

namespace mbncc {
namespace {

std::string path_of(const std::string& file) {
  return std::string(MBNCC_CONFIG_FOLDER) + "/" + file;
}

// The comment on the line of each key and on the lines below it.
std::map<std::string, std::string> lines_by_key(const std::string& file) {
  std::ifstream stream(path_of(file));
  std::map<std::string, std::string> lines;
  std::string key;
  for (std::string line; std::getline(stream, line);) {
    if (line.find_first_of(" #") != 0) key = line.substr(0, line.find(':'));
    lines[key] += line;
  }
  return lines;
}

template <class Config>
void expect_ranges(const std::string& file) {
  Config config;
  const auto lines = lines_by_key(file);
  for (const auto& row : field_rows(config)) {
    const std::string range = row.info.allowed.to_string();
    const bool is_told = lines.at(row.info.name).find(range) != std::string::npos;
    EXPECT_TRUE(is_told || !std::isfinite(row.info.allowed.low)) << row.info.name << ": " << range;
  }
}

template <class Config>
void expect_complete(const std::string& file) {
  std::set<std::string> keys;
  for (const auto& entry : YAML::LoadFile(path_of(file)))
    EXPECT_TRUE(keys.insert(entry.first.as<std::string>()).second) << "twice: " << entry.first;
  Config shipped, defaults;
  load_yaml_file(field_rows(shipped), path_of(file));
  const auto shipped_rows = field_rows(shipped), default_rows = field_rows(defaults);
  for (std::size_t i = 0; i < default_rows.size(); ++i) {
    const std::string& name = default_rows[i].info.name;
    EXPECT_EQ(keys.erase(name), 1u) << file << " lacks " << name;
    EXPECT_EQ(shipped_rows[i].value, default_rows[i].value) << name;
  }
  EXPECT_TRUE(keys.empty()) << file << " names " << *keys.begin();
  expect_ranges<Config>(file);
}

TEST(ShippedConfig, Camera) {
  expect_complete<CameraConfig>("camera.yaml");
}
TEST(ShippedConfig, Rectify) {
  expect_complete<RectifyConfig>("rectify.yaml");
}
TEST(ShippedConfig, SimulatedCamera) {
  expect_complete<SimulatedCameraConfig>("simulated_camera.yaml");
}
TEST(ShippedConfig, Learning) {
  expect_complete<LearningNodeConfig>("learning.yaml");
}
TEST(ShippedConfig, Matching) {
  expect_complete<MatchingNodeConfig>("matching.yaml");
}

/// Defaults must be in range, and every field must have a meaning.
template <class Config>
void expect_sound() {
  Config config;
  std::set<std::string> names;
  for (const auto& row : field_rows(config)) {
    EXPECT_TRUE(names.insert(row.info.name).second) << row.info.name;
    EXPECT_FALSE(row.info.meaning.empty()) << row.info.name;
    EXPECT_NO_THROW(row.assign(row.value)) << row.info.name;
  }
}

TEST(ShippedConfig, DefaultsAreAllowedAndFieldsExplained) {
  expect_sound<CameraConfig>();
  expect_sound<RectifyConfig>();
  expect_sound<SimulatedCameraConfig>();
  expect_sound<LearningNodeConfig>();
  expect_sound<MatchingNodeConfig>();
}

}  // namespace
}  // namespace mbncc
