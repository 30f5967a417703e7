#include <iostream>

#include "cli/command.hpp"
#include "cli/library_access.hpp"
#include "cli/settings.hpp"

namespace mbncc::cli {
namespace {

ExitCode run(const Arguments& arguments) {
  settings_from(arguments);
  const std::string name = arguments.get("--name");
  ObjectLibrary library = existing_library(arguments);
  named_object(*load_reporting(library), name);
  library.remove(name);
  std::cout << "forgot '" << name << "'; 'mbncc restore' brings it back\n";
  return kDone;
}

}  // namespace

Command forget_command() {
  return {"forget",
          "move an object to the library's trash",
          {library_option(), name_option()},
          "",
          "Replaced and forgotten revisions lie in DIR/.trash until you delete them there.\n",
          run};
}

}  // namespace mbncc::cli
