// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "cli/command.hpp"
#include "cli/library_access.hpp"
#include "cli/report/numbers.hpp"
#include "cli/settings.hpp"

namespace mbncc::cli {
namespace {

ExitCode run(const Arguments& arguments) {
  settings_from(arguments);
  const int revision = parse_whole("--revision", arguments.get("--revision", "0"), 0);
  ObjectLibrary library = existing_library(arguments);
  const auto object =
      library.restore(arguments.get("--name"), static_cast<std::uint32_t>(revision));
  std::cout << "restored '" << object.name << "' as revision " << object.revision << '\n';
  return kDone;
}

}  // namespace

Command restore_command() {
  return {"restore",
          "restore a replaced or forgotten revision",
          {library_option(),
           name_option(),
           {"--revision", "N", "number of the revision; default: the newest"}},
          "",
          "It becomes the next revision; the replaced one goes to the trash.\n",
          run};
}

}  // namespace mbncc::cli
