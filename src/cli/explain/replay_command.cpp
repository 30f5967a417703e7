// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "cli/command.hpp"
#include "cli/explain/explanation_report.hpp"
#include "cli/images.hpp"
#include "cli/settings.hpp"
#include "mbncc/miss/saved_miss.hpp"

namespace mbncc::cli {
namespace {

ExitCode run(const Arguments& arguments) {
  ExitCode code = kDone;
  for (const auto& file : arguments.operands()) {
    try {
      const SavedMiss miss = read_miss(file);
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
  return {"replay",
          "explain a saved miss again with this version",
          {json_option()},
          "FILE.miss",
          "Image, library and settings are those of the file, as written by the console's 'Save "
          "this miss'\n or by 'mbncc explain --save'. A file that cannot be read is reported, the "
          "others are\n run, and the exit code is 1.\n",
          run};
}

}  // namespace mbncc::cli
