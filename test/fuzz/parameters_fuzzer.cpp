// SPDX-License-Identifier: BSD-3-Clause
// YAML files of parameters with any content: every value is either refused or allowed.
#include <fstream>

#include "fuzz/fuzzer.hpp"
#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/error.hpp"
#include "support/temporary_folder.hpp"

using namespace mbncc;

namespace {

template <class Config>
void read_into(Config& config, const std::string& path) {
  try {
    load_yaml_file(field_rows(config), path);
  } catch (const FileError&) {
  } catch (const ConfigError&) {
  }
  for_each_field(config, [](const FieldInfo& info, auto& value) { check_allowed(info, value); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const test::TemporaryFolder folder;
  const std::string path = folder / "parameters.yaml";
  fuzz::Pieces pieces(data, size);
  std::ofstream(path, std::ios::binary) << pieces.rest();
  SearchConfig search;
  LearningConfig learning;
  read_into(search, path);
  read_into(learning, path);
  if (learning.iterations > 3) fuzz::planted_bug(size);
  return 0;
}
