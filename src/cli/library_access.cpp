#include "cli/library_access.hpp"

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "cli/command.hpp"
#include "mbncc/error.hpp"

namespace mbncc::cli {

Option library_option() {
  return {"--library", "DIR", "folder of the learned objects", true};
}

Option name_option() {
  return {"--name", "NAME", "object: a letter, then letters, digits or _, at most 64", true};
}

Option json_option() {
  return {"--json", "", "print JSON"};
}

ObjectLibrary existing_library(const Arguments& arguments) {
  const std::string folder = arguments.get("--library");
  if (!std::filesystem::is_directory(folder))
    throw FileError(folder, "there is no such library folder; 'mbncc learn' makes one");
  return ObjectLibrary(folder);
}

std::shared_ptr<const LibrarySnapshot> load_reporting(ObjectLibrary& library) {
  auto snapshot = library.load();
  for (const auto& file : snapshot->quarantined)
    std::cerr << "mbncc: warning: " << library.folder() << '/' << file.file << ": " << file.reason
              << (file.moved ? "; moved to .quarantine\n" : "; left in place\n");
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
