// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <stdexcept>

#include "cli/command.hpp"
#include "cli/library_access.hpp"
#include "cli/report/numbers.hpp"
#include "cli/settings.hpp"
#include "mbncc/object_views.hpp"

namespace mbncc::cli {
namespace {

ExitCode forget_view(ObjectLibrary& library, const std::string& name, const std::string& text) {
  const int number = parse_whole("--view", text, 1);
  const auto left = library.edit(name, [&](ObjectModel& model) {
    if (number == 1 && model.views.size() == 1)
      throw std::invalid_argument("'" + name + "' has no other view; use 'mbncc forget --name " +
                                  name + "'");
    remove_view(model, static_cast<std::size_t>(number));
  });
  std::cout << "forgot view " << number << " of '" << name << "'; " << left.views.size()
            << " left; 'mbncc restore' restores it\n";
  return kDone;
}

ExitCode run(const Arguments& arguments) {
  settings_from(arguments);
  const std::string name = arguments.get("--name");
  ObjectLibrary library = existing_library(arguments);
  named_object(*load_reporting(library), name);
  if (arguments.has("--view")) return forget_view(library, name, arguments.get("--view"));
  library.remove(name);
  std::cout << "forgot '" << name << "'; 'mbncc restore' restores it\n";
  return kDone;
}

}  // namespace

Command forget_command() {
  return {
      "forget",
      "move an object to the library's trash",
      {library_option(), name_option(), {"--view", "K", "only its view K, as numbered by 'show'"}},
      "",
      "Replaced and forgotten revisions stay in DIR/.trash until you delete them.\n",
      run};
}

}  // namespace mbncc::cli
