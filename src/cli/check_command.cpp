#include <iostream>

#include "cli/command.hpp"
#include "cli/library_access.hpp"
#include "cli/settings.hpp"

namespace mbncc::cli {
namespace {

// Those moved by this check are in the quarantine too.
std::vector<QuarantinedFile> faulty_files(const ObjectLibrary& library,
                                          const LibrarySnapshot& snapshot) {
  auto faulty = library.quarantine();
  for (const auto& file : snapshot.quarantined)
    if (!file.moved) faulty.push_back(file);
  return faulty;
}

ExitCode run(const Arguments& arguments) {
  settings_from(arguments);
  ObjectLibrary library = existing_library(arguments);
  const auto snapshot = library.load();
  const auto faulty = faulty_files(library, *snapshot);
  std::cout << snapshot->objects.size() << " readable, " << faulty.size() << " unreadable\n";
  for (const auto& file : faulty)
    std::cerr << (file.moved ? ".quarantine/" : "") << file.file << ": " << file.reason << '\n';
  if (faulty.empty()) return kDone;
  std::cerr << "Teach these objects again or restore them from the trash, then delete "
            << library.folder() << "/.quarantine.\n";
  return kFailed;
}

}  // namespace

Command check_command() {
  return {"check",
          "read every file of the library and report what is unreadable",
          {library_option()},
          "",
          "Unreadable files are moved to DIR/.quarantine, their reasons beside them. Exit code 1\n"
          "as long as there are any.\n",
          run};
}

}  // namespace mbncc::cli
