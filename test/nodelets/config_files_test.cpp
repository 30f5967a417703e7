// Every shipped YAML names every field of its struct, with its default, and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

#include "mbncc/config/learning_node_config.hpp"
#include "mbncc/config/matching_node_config.hpp"

namespace mbncc {
namespace {

const std::string kFolder = MBNCC_CONFIG_FOLDER "/";

std::set<std::string> keys_of(const std::string& path) {
  std::ifstream file(path);
  std::set<std::string> keys;
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(':');
    if (colon == std::string::npos || line[0] == '#' || line[0] == ' ') continue;
    keys.insert(line.substr(0, colon));
  }
  return keys;
}

template <class Config>
void expect_defaults(const std::string& path) {
  Config config;
  const auto rows = field_rows(config);
  load_yaml_file(rows, path);  // throws for an unknown key
  std::set<std::string> fields;
  for (const auto& row : rows) fields.insert(row.info.name);
  EXPECT_EQ(keys_of(path), fields);
  Config defaults;
  const auto read = field_rows(config), expected = field_rows(defaults);
  for (std::size_t i = 0; i < read.size(); ++i)
    EXPECT_EQ(read[i].value, expected[i].value) << read[i].info.name;
}

TEST(ConfigFiles, MatchingYamlHoldsEveryFieldAndItsDefault) {
  expect_defaults<MatchingNodeConfig>(kFolder + "matching.yaml");
}

TEST(ConfigFiles, LearningYamlHoldsEveryFieldAndItsDefault) {
  expect_defaults<LearningNodeConfig>(kFolder + "learning.yaml");
}

}  // namespace
}  // namespace mbncc
