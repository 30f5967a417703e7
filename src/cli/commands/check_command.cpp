// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iostream>

#include "cli/command.hpp"
#include "cli/library_access.hpp"
#include "cli/settings.hpp"

namespace mbncc::cli {
namespace {

// Includes the files that this check has moved to the quarantine.
std::vector<QuarantinedFile> faulty_files(const ObjectLibrary& library,
                                          const LibrarySnapshot& snapshot) {
  auto faulty = library.quarantine();
  for (const auto& file : snapshot.quarantined)
    if (!file.moved) faulty.push_back(file);
  return faulty;
}

// "bracket" for "bracket.png" and for "bracket.png.2", which is a second file of that name in the
// quarantine.
std::string object_of(const QuarantinedFile& file) {
  return file.file.substr(0, file.file.find('.'));
}

// Restores the newest stored revision of every object whose file is unreadable and that is missing
// in the library. An object that was stored again later is missing because somebody removed it.
void bring_back(const std::vector<QuarantinedFile>& faulty, ObjectLibrary& library) {
  for (const auto& file : faulty) {
    const std::string name = object_of(file);
    if (!file.moved || library.load()->find(name) != nullptr) continue;
    try {
      if (library.trashed_since(name, file)) continue;
      const ObjectModel object = library.restore(name);
      std::cout << "brought '" << name << "' from the trash as revision " << object.revision
                << "; later changes are lost\n";
    } catch (const std::exception& error) {
      std::cerr << "'" << name << "' cannot be restored: " << error.what() << '\n';
    }
  }
}

ExitCode run(const Arguments& arguments) {
  settings_from(arguments);
  ObjectLibrary library = existing_library(arguments);
  auto snapshot = library.load();
  const auto faulty = faulty_files(library, *snapshot);
  if (arguments.has("--repair")) {
    bring_back(faulty, library);
    snapshot = library.load();
  }
  std::cout << snapshot->objects.size() << " readable, " << faulty.size() << " unreadable\n";
  for (const auto& file : faulty)
    std::cerr << (file.moved ? ".quarantine/" : "") << file.file << ": " << file.reason << '\n';
  for (const auto& file : snapshot->other_images)
    std::cerr << file << ": not an object; left in place\n";
  if (faulty.empty()) return kDone;
  const bool moved =
      std::any_of(faulty.begin(), faulty.end(), [](auto& file) { return file.moved; });
  if (moved)
    std::cerr << "Teach these objects again or restore them from the trash, then delete "
              << library.folder() << "/.quarantine.\n";
  return kFailed;
}

}  // namespace

Command check_command() {
  return {
      "check",
      "read every file of the library and report unreadable ones",
      {library_option(),
       {"--repair", "", "restore the newest revision of unreadable objects from the trash"}},
      "",
      "Unreadable files are moved to DIR/.quarantine, with their reasons; those that changed in\n "
      "the last five seconds stay, because they may still be being copied. The exit code is 1\n "
      "while there are any.\n",
      run};
}

}  // namespace mbncc::cli
