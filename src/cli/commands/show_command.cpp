// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "cli/command.hpp"
#include "cli/library_access.hpp"
#include "cli/report/object_report.hpp"
#include "cli/settings.hpp"

namespace mbncc::cli {
namespace {

ExitCode run(const Arguments& arguments) {
  settings_from(arguments);
  ObjectLibrary library = existing_library(arguments);
  const auto object = named_object(*load_reporting(library), arguments.get("--name"));
  JsonWriter json(std::cout);
  if (arguments.has("--json"))
    write_object(json, *object);
  else
    print_object(std::cout, *object);
  return kDone;
}

}  // namespace

Command show_command() {
  return {"show",
          "describe one object",
          {library_option(), name_option(), json_option()},
          "",
          "Its image is DIR/NAME.png, which any image viewer shows.\n",
          run};
}

}  // namespace mbncc::cli
