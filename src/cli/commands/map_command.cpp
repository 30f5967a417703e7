// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "cli/command.hpp"
#include "cli/images.hpp"
#include "cli/library_access.hpp"
#include "cli/settings.hpp"

namespace mbncc::cli {
namespace {

ExitCode run(const Arguments& arguments) {
  settings_from(arguments);
  ObjectLibrary library = existing_library(arguments);
  const auto object = named_object(*load_reporting(library), arguments.get("--name"));
  write_image(arguments.get("--out"), full_size_map(object->views.front()), {});
  std::cerr << "mbncc: wrote " << arguments.get("--out") << '\n';
  return kDone;
}

}  // namespace

Command map_command() {
  return {"map",
          "write an object's map at the size of its learning image",
          {library_option(), name_option(), {"--out", "map.png", "file to write", true}},
          "",
          "The map of the first view: 255 on the object, 0 elsewhere.\n",
          run};
}

}  // namespace mbncc::cli
