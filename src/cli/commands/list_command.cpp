// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iomanip>
#include <iostream>

#include "cli/command.hpp"
#include "cli/library_access.hpp"
#include "cli/report/object_report.hpp"
#include "cli/settings.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc::cli {
namespace {

/// The declared symmetry, otherwise the measured one, which is marked.
std::string symmetry_of(const ObjectModel& object) {
  if (object.symmetry) return symmetry_text(object.symmetry);
  return symmetry_text(object.quality.symmetry) + " (auto)";
}

void print_table(const LibrarySnapshot& snapshot) {
  std::size_t width = 4;
  for (const auto& object : snapshot.objects) width = std::max(width, object->name.size());
  const auto column = [width](const std::string& name) {
    std::cout << std::left << std::setw(static_cast<int>(width)) << name;
  };
  column("name");
  std::cout << "  revision  views  enabled  symmetry      verdict   learned\n";
  for (const auto& object : snapshot.objects) {
    column(object->name);
    std::cout << std::right << std::setw(10) << object->revision << std::setw(7)
              << object->views.size() << std::setw(9) << (object->enabled ? "yes" : "no") << "  "
              << std::left << std::setw(14) << symmetry_of(*object) << std::setw(10)
              << to_string(object->quality.verdict) << time_text(object->learned_at) << '\n';
  }
}

void print_json(const LibrarySnapshot& snapshot) {
  for (const auto& object : snapshot.objects) {
    JsonWriter json(std::cout);
    write_object(json, *object);
  }
}

ExitCode run(const Arguments& arguments) {
  settings_from(arguments);
  ObjectLibrary library = existing_library(arguments);
  const auto snapshot = load_objects(library);
  if (arguments.has("--json"))
    print_json(*snapshot);
  else
    print_table(*snapshot);
  return kDone;
}

}  // namespace

Command list_command() {
  return {"list", "list the learned objects", {library_option(), json_option()}, "", "", run};
}

}  // namespace mbncc::cli
