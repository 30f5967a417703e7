// SPDX-License-Identifier: BSD-3-Clause
#include "cli/library_access.hpp"

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "cli/command.hpp"
#include "cli/settings.hpp"
#include "mbncc/error.hpp"
#include "mbncc/home_folder.hpp"

namespace mbncc::cli {

Option library_option() {
  return {"--library", "DIR",
          "folder of the learned objects; default: library_path, as for the nodelets"};
}

Option name_option() {
  return {"--name", "NAME", "object: a letter, then letters, digits or _, at most 64", true};
}

Option json_option() {
  return {"--json", "", "print JSON"};
}

std::string library_folder(const Arguments& arguments) {
  return expand_home(arguments.has("--library") ? arguments.get("--library")
                                                : settings_from(arguments).learning.library_path);
}

ObjectLibrary existing_library(const Arguments& arguments) {
  const std::string folder = library_folder(arguments);
  if (!std::filesystem::exists(folder))
    throw FileError(folder, "there is no such library folder; 'mbncc learn' makes one");
  return ObjectLibrary(folder);
}

std::shared_ptr<const LibrarySnapshot> load_reporting(ObjectLibrary& library) {
  auto snapshot = library.load();
  for (const auto& file : snapshot->quarantined)
    std::cerr << "mbncc: warning: " << library.folder() << '/' << file.file << ": " << file.reason
              << (file.moved ? "; moved to .quarantine\n" : "; left in place\n");
  for (const auto& file : snapshot->other_images)
    std::cerr << "mbncc: warning: " << library.folder() << '/' << file
              << ": not an object; left in place\n";
  return snapshot;
}

std::shared_ptr<const LibrarySnapshot> load_objects(ObjectLibrary& library) {
  auto snapshot = load_reporting(library);
  if (snapshot->objects.empty())
    throw std::runtime_error(library.folder() + ": the library has no objects; teach one first");
  return snapshot;
}

std::shared_ptr<const ObjectModel> named_object(const LibrarySnapshot& snapshot,
                                                const std::string& name) {
  if (auto object = snapshot.find(name)) return object;
  std::string known;
  for (const auto& object : snapshot.objects) known += (known.empty() ? "" : ", ") + object->name;
  throw std::invalid_argument("the library has no object '" + name + "'; it has " +
                              (known.empty() ? "none" : known));
}

}  // namespace mbncc::cli
