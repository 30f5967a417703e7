// A folder of learned objects, one file each, safe against crashes: every change is one atomic
// step.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mbncc/object_model.hpp"

namespace mbncc {

/// A file that could not be read and was moved to `.quarantine/`.
struct QuarantinedFile {
  std::string file;  ///< name within the library folder
  std::string reason;
};

/// Immutable state of a library at one moment; share it freely between threads.
struct LibrarySnapshot {
  std::vector<std::shared_ptr<const ObjectModel>> objects;  ///< sorted by name
  std::vector<QuarantinedFile> quarantined;                 ///< by this load

  std::shared_ptr<const ObjectModel> find(const std::string& name) const;  ///< null: unknown
};

/// Writers work under an exclusive lock on the folder (flock), so one writes at a time, across
/// processes. All functions throw FileError (with errno's text) when a file operation fails; then
/// the library is as before.
class ObjectLibrary {
 public:
  /// Opens `folder`, creating it when missing.
  explicit ObjectLibrary(std::string folder);

  const std::string& folder() const { return folder_; }

  /// Reads all files; unreadable ones are moved to `.quarantine/` with their reason, the rest
  /// loads. Objects whose file has not changed since the last load keep their pointer.
  std::shared_ptr<const LibrarySnapshot> load();

  /// True when a file was added, changed or removed since the last load() of this instance.
  bool changed_on_disk() const;

  /// What save() does about a name that is taken.
  enum class Existing { kRefuse, kReplace };

  /// Stores `model` durably: temporary file, fsync, rename, fsync of the folder. Replacing moves
  /// the old revision to `.trash/` and stores revision + 1. Returns the model as stored. Throws
  /// std::invalid_argument for a name that is taken (kRefuse) or a model that breaks the rules.
  ObjectModel save(ObjectModel model, Existing existing);

  /// Applies `edit` to the stored object under the lock and stores the result as the next revision.
  /// Throws std::invalid_argument when the name is unknown.
  template <class Edit>
  ObjectModel edit(const std::string& name, Edit&& edit);

  /// New key and/or label; an empty argument keeps the old one. Throws std::invalid_argument when
  /// the name is unknown or the new one invalid or taken.
  ObjectModel rename(const std::string& name, const std::string& new_name,
                     const std::string& label);

  /// Moves the object to `.trash/`.
  void remove(const std::string& name);

  /// Brings a revision back from the trash (0: the newest there) as the next revision of that name.
  ObjectModel restore(const std::string& name, std::uint32_t revision = 0);

 private:
  std::string folder_;
};

}  // namespace mbncc
