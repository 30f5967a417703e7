// SPDX-License-Identifier: BSD-3-Clause
// A folder of learned objects, one file each. It is safe against crashes, because every change is
// one atomic step.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mbncc/error.hpp"
#include "mbncc/library/library_snapshot.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

class LibraryCache;

/// A name that already exists, is unknown or is not allowed; `what()` gives the reason.
class NameError : public std::invalid_argument {
 public:
  NameError(LearnError code, const std::string& sentence)
      : std::invalid_argument(sentence), code_(code) {}

  /// kNameTaken, kNameUnknown or kNameInvalid.
  LearnError code() const { return code_; }

 private:
  LearnError code_;
};

/// Number of the folder in its file system, which is the same on every computer that has access to
/// it; 0: there is no such folder.
std::uint64_t folder_inode(const std::string& folder);

/// Writers hold an exclusive lock on the folder (flock), so only one writes at a time, across
/// processes; readers need no lock, because every file is replaced atomically. All functions throw
/// FileError (with errno's text) if a file operation fails; the library is then unchanged, except
/// that rename() may have stored the new label, and that a change whose folder could not be synced
/// is made. A writer that waits longer than 10 s for the lock throws FileError.
///
/// Revisions increase per name and are not reused, even after a removal or a rename, as long as
/// the trash is not emptied. One instance serves one thread at a time.
class ObjectLibrary {
 public:
  /// Opens `folder`; creates it and its parents if they are missing.
  explicit ObjectLibrary(std::string folder);
  ~ObjectLibrary();
  ObjectLibrary(ObjectLibrary&&) noexcept;
  ObjectLibrary& operator=(ObjectLibrary&&) noexcept;

  const std::string& folder() const { return folder_; }

  /// Reads all files, moves unreadable ones to `.quarantine/` with the reason and loads the others.
  /// A file that was changed in the last seconds may be incomplete, so it is not moved yet.
  /// An intact PNG file that is not an object stays in place, and its name is not available.
  /// Objects whose file has not changed since the last load keep their pointer.
  std::shared_ptr<const LibrarySnapshot> load();

  /// True if a file was added, changed or removed since the last load() of this instance, or if one
  /// that could not be read then can be read or quarantined now.
  bool changed_on_disk() const;

  /// Writes 1 MB durably and removes it again, to check before a lesson that its result can be
  /// stored. Does not wait for other writers.
  void check_storage() const;

  /// The contents of `.quarantine/`, from this and earlier loads, with the reasons.
  std::vector<QuarantinedFile> quarantine() const;

  /// True if an object of this name was replaced or removed after `file` had been moved to the
  /// quarantine. Throws FileError if the trash cannot be read.
  bool trashed_since(const std::string& name, const QuarantinedFile& file) const;

  /// What save() does if the name exists.
  enum class Existing { kRefuse, kReplace };

  /// Stores `model` durably: temporary file, fsync, rename, fsync of the folder. If an object is
  /// replaced, its old revision is moved to `.trash/`. Returns the model as stored, with its new
  /// revision. Throws NameError for an existing name (kRefuse), std::invalid_argument for a model
  /// that violates the rules or does not fit into a file.
  ObjectModel save(ObjectModel model, Existing existing);

  /// Applies `change` to the stored object under the lock and stores the result. If the change
  /// moves poses (views, references, scale, height, declared symmetry, grasp), the result is the
  /// next revision, and the old one is moved to the trash. If `change` throws, the object stays
  /// unchanged. Throws NameError if the name is unknown, std::invalid_argument like save().
  ObjectModel edit(const std::string& name, const std::function<void(ObjectModel&)>& change);

  /// Changes name, label or both; an empty argument keeps the old one. The trash keeps a copy under
  /// the old name. Throws NameError if the name is unknown or the new one is invalid or taken.
  ObjectModel rename(const std::string& name, const std::string& new_name,
                     const std::string& label);

  /// Moves the object to `.trash/` and returns it. Throws NameError if the name is unknown.
  ObjectModel remove(const std::string& name);

  /// Restores a revision from the trash (0: the newest readable one) as the next revision of that
  /// name; an object that it replaces is moved to the trash. Throws NameError if there is no such
  /// revision or the name is not allowed.
  ObjectModel restore(const std::string& name, std::uint32_t revision = 0);

 private:
  std::string folder_;
  std::unique_ptr<LibraryCache> cache_;
};

}  // namespace mbncc
