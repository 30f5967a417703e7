// SPDX-License-Identifier: BSD-3-Clause
// The layout of a library folder on disk: `<name>.png`, `.lock`, `.trash/<name>.<revision>.png`,
// `.quarantine/<file>` with `<file>.reason.txt`. Changes need the lock, see LockedFolder.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "library/file_io.hpp"
#include "mbncc/library/library_snapshot.hpp"
#include "mbncc/library/object_file.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::library {

constexpr const char* kReasonEnding = ".reason.txt";

/// Paths within a library folder.
struct LibraryFolder {
  std::string path;

  std::string object_file(const std::string& name) const {
    return path + "/" + name + kObjectFileEnding;
  }
  std::string trash() const { return path + "/.trash"; }
  std::string quarantine() const { return path + "/.quarantine"; }
  std::string lock_file() const { return path + "/.lock"; }
};

/// The contents of the quarantine with their reasons.
std::vector<QuarantinedFile> quarantined_files(const LibraryFolder& folder);

/// See ObjectLibrary::trashed_since().
bool trashed_since(const LibraryFolder& folder, const std::string& name,
                   const QuarantinedFile& file);

/// Names of the object files: *.png, except hidden ones.
std::vector<std::string> object_files(const LibraryFolder& folder);

/// Throws FileError if the file of this name is an image but not an object.
void refuse_other_image(const std::string& object_file);

/// Throws ContentError if the file's name is not an object's name followed by ".png":
/// "wrench.1.png" is not a second wrench.
void check_file_name(const LibraryFolder& folder, const std::string& file);

/// Revisions of `name` in the trash and their paths. Throws FileError if the trash is not a folder.
std::map<std::uint32_t, std::string> trashed_revisions(const LibraryFolder& folder,
                                                       const std::string& name);

/// Whether a file of the trash was left by a rename: it keeps the revision from being used again.
bool is_left_by_rename(const std::string& path);

/// See ObjectLibrary::check_storage().
void check_storage(const LibraryFolder& folder);

/// Exclusive access for one writer. The constructor waits for the lock for at most 10 s and removes
/// the leftovers of a crashed writer. Throws FileError.
class LockedFolder {
 public:
  explicit LockedFolder(LibraryFolder folder);

  /// The stored object; null if there is none. An unreadable file is quarantined and counts as
  /// none. Throws FileError if the file of this name is an image but not an object, or may not be
  /// complete yet.
  std::unique_ptr<ObjectModel> read(const std::string& name);

  /// One above every revision of `name`: that of `stored` (may be null), those in the trash and
  /// those in the quarantine. The smallest free revision if the result would exceed the limit.
  std::uint32_t next_revision(const std::string& name, const ObjectModel* stored) const;

  /// Stores the model as it is. With `keep_old`, the file that it replaces is moved to the trash
  /// under that revision, unless storing fails.
  void write(const ObjectModel& model, const ObjectModel* keep_old);

  /// Moves the object to the trash.
  void discard(const ObjectModel& model);

  /// Renames the object's file; the new name must be free. The trash keeps the file under its old
  /// name, so that no other object of that name gets its revision.
  void rename(const ObjectModel& model, const std::string& new_name);

  /// Moves `file` to the quarantine and returns true, unless it can be read under the lock or has
  /// changed since it had this stamp.
  bool quarantine_unreadable(const std::string& file, const FileStamp& stamp);

 private:
  void quarantine(const std::string& file, const std::string& reason);
  /// `ending`: of the file's name, after the revision.
  std::string link_to_trash(const ObjectModel& model, const std::string& ending = "");

  LibraryFolder folder_;
  FileDescriptor lock_;
};

}  // namespace mbncc::library
