// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "cli/command.hpp"
#include "cli/explain/explanation_report.hpp"
#include "cli/images.hpp"
#include "cli/settings.hpp"
#include "mbncc/miss/saved_miss.hpp"

namespace mbncc::cli {
namespace {

SearchConfig changed(const SearchConfig& saved, const Arguments& arguments) {
  Settings settings;
  settings.search() = saved;
  change_settings(settings, arguments);
  return settings.search();
}

ExitCode run(const Arguments& arguments) {
  settings_from(arguments);  // wrong usage is no fault of a file
  ExitCode code = kDone;
  for (const auto& file : arguments.operands()) {
    try {
      SavedMiss miss = read_miss(file);
      miss.search = changed(miss.search, arguments);
      const auto explanations = explain(miss);
      if (arguments.has("--json")) {
        write_explanations(std::cout, file, miss.place, explanations);
        continue;
      }
      std::cout << file << '\n';
      print_explanations(std::cout, explanations);
      const bool same = lines_of(explanations, kExplained) == miss.lines;
      std::cout << (same ? "  as when it was saved\n" : "  when it was saved:\n");
      if (!same)
        for (const auto& line : miss.lines) std::cout << "    " << line << '\n';
    } catch (const std::exception& error) {
      std::cerr << "mbncc: " << error.what() << '\n';
      code = kFailed;
    }
  }
  return code;
}

}  // namespace

Command replay_command() {
  return {
      "replay",
      "explain a saved miss again with this version",
      {json_option()},
      "FILE.miss",
      "Image, library and settings are those of the file, as written by the console's 'Save "
      "this miss'\n or by 'mbncc explain --save'; --config and --set change the settings. A file "
      "that cannot be\n read is reported, the others are run, and the exit code is 1.\n",
      run};
}

}  // namespace mbncc::cli
