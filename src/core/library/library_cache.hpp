// SPDX-License-Identifier: BSD-3-Clause
// Caches a library folder, so that the next load reads only changed files.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "library/library_folder.hpp"
#include "mbncc/library/library_snapshot.hpp"

namespace mbncc {

class LibraryCache {
 public:
  /// Reads new and changed files and quarantines unreadable ones.
  std::shared_ptr<const LibrarySnapshot> load(const library::LibraryFolder& folder);

  /// True if the folder differs from what was last loaded, or a passing fault has passed.
  bool is_stale(const library::LibraryFolder& folder) const;

 private:
  // What a file holds; valid until it changes, except kUncertain: the fault may pass by itself.
  enum class State { kObject, kOtherImage, kNewer, kDamaged, kUncertain };
  struct Entry {
    library::FileStamp stamp;
    State state;
    std::string reason;                         // why it is unreadable
    std::shared_ptr<const ObjectModel> object;  // only of kObject
  };

  static Entry read(const library::LibraryFolder& folder, const std::string& file,
                    const library::FileStamp& stamp);
  std::optional<Entry> load_file(const library::LibraryFolder& folder, const std::string& file,
                                 LibrarySnapshot& snapshot) const;

  std::map<std::string, Entry> entries_;  // by file name
};

}  // namespace mbncc
