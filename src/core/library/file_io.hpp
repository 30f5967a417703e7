// SPDX-License-Identifier: BSD-3-Clause
// File access of the library: bounded reads, and writes that leave the old or the new file after a
// crash. Interrupted POSIX calls are repeated; failures throw FileError with errno's text.
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mbncc/error.hpp"

namespace mbncc::library {

/// An error in a file's content, not a system error: such files are moved to the quarantine.
class ContentError : public FileError {
 public:
  using FileError::FileError;
};

/// A file of a newer version of this package.
class NewerFileError : public FileError {
 public:
  using FileError::FileError;
};

/// Text of an errno code, such as "No space left on device".
std::string errno_text(int code);

/// Owns an open file.
class FileDescriptor {
 public:
  explicit FileDescriptor(int descriptor) : descriptor_(descriptor) {}
  ~FileDescriptor();
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  int get() const { return descriptor_; }
  bool is_open() const { return descriptor_ >= 0; }

  /// Closes the file now; returns errno's code, or 0.
  int close();

 private:
  int descriptor_;
};

/// Identifies the state of a file, so that changes can be detected.
struct FileStamp {
  std::uint64_t device = 0, inode = 0;
  std::int64_t size = 0, modified_ns = 0, changed_ns = 0;

  explicit FileStamp(const struct stat& status);
  FileStamp() = default;
  bool operator==(const FileStamp& other) const;
};

/// True if the file was changed in the last seconds, so that it may not be complete yet. False
/// for a file dated further into the future: a wrong clock must not make it incomplete for ever.
bool changed_recently(const FileStamp& stamp);

struct FileContent {
  std::vector<std::uint8_t> bytes;
  FileStamp stamp;
};

/// Reads a regular file of at most `max_bytes`. Throws ContentError for anything else (FIFO,
/// folder, symbolic link, too large), FileError for a system error.
FileContent read_regular_file(const std::string& path, std::size_t max_bytes);

/// Prefix of temporary files; those found under the folder's lock are leftovers of a crash. It
/// names the package, because other programs may keep temporary files in the folder.
constexpr const char* kTemporaryPrefix = ".mbncc-tmp-";

/// Writes `folder/name` durably and atomically: temporary file, fsync, rename, fsync of the folder.
/// On failure, the old file is unchanged and no temporary file is left.
void write_file_atomically(const std::string& folder, const std::string& name,
                           const std::vector<std::uint8_t>& bytes);

/// Writes a temporary file of this size durably, as write_file_atomically() does, and removes it.
void try_to_write(const std::string& folder, std::size_t bytes);

/// Removes leftovers of crashed writers; call this only under the folder's lock.
void remove_temporaries(const std::string& folder);

/// Makes created, renamed and removed entries of a folder durable. The folder is opened before the
/// change, so that less can fail afterwards.
class FolderSync {
 public:
  explicit FolderSync(const std::string& folder);

  void sync();

 private:
  std::string folder_;
  FileDescriptor file_;
};

/// Creates the folder and its parents if they are missing. Refuses a file of this name.
void make_folder(const std::string& folder);

/// Like make_folder(), for a folder inside the library: a symbolic link is refused, because it may
/// point anywhere.
void make_inner_folder(const std::string& folder);

/// True if the folder exists; throws FileError for a symbolic link or anything else.
bool is_inner_folder(const std::string& folder);

/// rename(2), replacing `to`.
void rename_path(const std::string& from, const std::string& to);

/// Stamp of the entry of this name, without following links; none if there is no such entry.
std::optional<FileStamp> stamp_of(const std::string& path);

/// True if an entry of this name exists.
bool path_exists(const std::string& path);

/// Names of a folder's entries, sorted.
std::vector<std::string> entries_of(const std::string& folder);

}  // namespace mbncc::library
