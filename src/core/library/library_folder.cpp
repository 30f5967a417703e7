// SPDX-License-Identifier: BSD-3-Clause
#include "library/library_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <thread>

#include "library/object_yaml.hpp"
#include "library/other_image.hpp"
#include "library/png_codec.hpp"

namespace mbncc::library {
namespace {

using namespace std::chrono_literals;

constexpr const char* kRenamedEnding = ".renamed";
constexpr std::size_t kMaxReason = 4096;  // [bytes]
constexpr std::size_t kTrial = 1 << 20;   // [bytes] more than most objects need
constexpr auto kLockPatience = 10s;
constexpr auto kLockPoll = 5ms;

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() > ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

FileDescriptor open_lock(const LibraryFolder& folder) {
  const int descriptor =
      ::open(folder.lock_file().c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0644);
  if (descriptor < 0) throw FileError(folder.path, "cannot be written: " + errno_text(errno));
  return FileDescriptor(descriptor);
}

// Polls with a time limit, so that a stopped writer does not block others forever.
void lock(const FileDescriptor& file, const LibraryFolder& folder) {
  const auto deadline = std::chrono::steady_clock::now() + kLockPatience;
  while (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR)
      throw FileError(folder.path, "cannot be locked: " + errno_text(errno));
    if (std::chrono::steady_clock::now() > deadline)
      throw FileError(
          folder.path,
          "another program has been writing to this library for 10 s; try again, or end it");
    std::this_thread::sleep_for(kLockPoll);
  }
}

// A free path: `stem` + `ending`, or with a number between them.
std::string free_path(const std::string& stem, const std::string& ending) {
  std::string path = stem + ending;
  for (int i = 2; path_exists(path); ++i) path = stem + "." + std::to_string(i) + ending;
  return path;
}

// Revision of a file in the trash, `name.<revision>.png` or `name.<revision>.<n>.png`; 0 if the
// library has not named it.
std::uint32_t revision_in(const std::string& file, const std::string& name) {
  const std::string start = name + ".";
  if (file.rfind(start, 0) != 0 || !ends_with(file, kObjectFileEnding)) return 0;
  std::uint32_t revision = 0;
  const char* digits = file.data() + start.size();
  const auto read = std::from_chars(digits, file.data() + file.size(), revision);
  const bool given = read.ec == std::errc() && *read.ptr == '.' && revision <= kMaxRevision;
  return given ? revision : 0;
}

/// Revision in the description of a damaged file; 0 if the description is damaged as well.
std::uint32_t revision_described_in(const std::string& path) {
  try {
    const auto content = read_regular_file(path, PngLimits::kMaxBytes);
    return read_description(PngReader(content.bytes, kTextKey).text()).model.revision;
  } catch (const std::exception&) {
    return 0;
  }
}

/// The largest revision of `name` that the quarantine holds. `known`: the largest other one, which
/// a file without a readable description is taken to have followed.
std::uint32_t largest_quarantined(const LibraryFolder& folder, const std::string& name,
                                  std::uint32_t known) {
  std::uint32_t largest = 0, unknown = 0;
  for (const auto& quarantined : quarantined_files(folder)) {
    if (quarantined.file.substr(0, quarantined.file.find('.')) != name) continue;
    const auto revision = revision_described_in(folder.quarantine() + "/" + quarantined.file);
    largest = std::max(largest, revision);
    if (revision == 0) ++unknown;
  }
  return std::min(std::max(largest, known) + unknown, kMaxRevision);
}

std::string reason_beside(const std::string& path) {
  try {
    const auto bytes = read_regular_file(path + kReasonEnding, kMaxReason).bytes;
    return std::string(bytes.begin(), std::find(bytes.begin(), bytes.end(), '\n'));
  } catch (const FileError&) {
    return "reason unknown";
  }
}

}  // namespace

std::vector<std::string> object_files(const LibraryFolder& folder) {
  std::vector<std::string> files;
  for (const auto& name : entries_of(folder.path))
    if (name.front() != '.' && ends_with(name, kObjectFileEnding)) files.push_back(name);
  return files;
}

void check_file_name(const LibraryFolder& folder, const std::string& file) {
  if (!is_valid_name(file.substr(0, file.rfind(kObjectFileEnding))))
    throw ContentError(folder.path + "/" + file, "the file's name is not a valid object name");
}

void refuse_other_image(const std::string& object_file) {
  if (is_other_image(object_file))
    throw FileError(object_file,
                    "an image that is not an object has this name; choose another name or move "
                    "the image away");
}

std::vector<QuarantinedFile> quarantined_files(const LibraryFolder& folder) {
  std::vector<QuarantinedFile> files;
  if (!is_inner_folder(folder.quarantine())) return files;
  for (const auto& name : entries_of(folder.quarantine())) {
    if (name.front() == '.' || ends_with(name, kReasonEnding)) continue;
    files.push_back({name, reason_beside(folder.quarantine() + "/" + name)});
  }
  return files;
}

bool is_left_by_rename(const std::string& path) {
  return ends_with(path, kRenamedEnding + std::string(kObjectFileEnding));
}

std::map<std::uint32_t, std::string> trashed_revisions(const LibraryFolder& folder,
                                                       const std::string& name) {
  std::map<std::uint32_t, std::string> revisions;
  if (!is_inner_folder(folder.trash())) return revisions;
  for (const auto& file : entries_of(folder.trash()))
    if (const auto revision = revision_in(file, name))
      revisions[revision] = folder.trash() + "/" + file;
  return revisions;
}

// The time of a file's last change of state is that of its move to the trash, even if it was copied
// into the library with its older date.
bool trashed_since(const LibraryFolder& folder, const std::string& name,
                   const QuarantinedFile& file) {
  const auto reason = stamp_of(folder.quarantine() + "/" + file.file + kReasonEnding);
  const auto revisions = trashed_revisions(folder, name);
  return reason && std::any_of(revisions.begin(), revisions.end(), [&](const auto& revision) {
           const auto trashed = stamp_of(revision.second);
           return trashed && !is_left_by_rename(revision.second) &&
                  trashed->changed_ns >= reason->changed_ns;
         });
}

void check_storage(const LibraryFolder& folder) {
  open_lock(folder);
  try_to_write(folder.path, kTrial);
}

LockedFolder::LockedFolder(LibraryFolder folder)
    : folder_(std::move(folder)), lock_(open_lock(folder_)) {
  lock(lock_, folder_);
  remove_temporaries(folder_.path);
}

std::unique_ptr<ObjectModel> LockedFolder::read(const std::string& name) {
  const std::string path = folder_.object_file(name);
  const auto stamp = is_valid_name(name) ? stamp_of(path) : std::nullopt;
  if (!stamp) return nullptr;
  try {
    return std::make_unique<ObjectModel>(read_object_file(path));
  } catch (const ContentError& error) {
    refuse_other_image(path);
    if (changed_recently(*stamp))
      throw FileError(path, error.reason() +
                                "; the file may still be being copied, try again in a few seconds");
    quarantine(name + kObjectFileEnding, error.reason());
    return nullptr;
  }
}

std::uint32_t LockedFolder::next_revision(const std::string& name,
                                          const ObjectModel* stored) const {
  const auto trashed = trashed_revisions(folder_, name);
  const std::uint32_t last = stored == nullptr ? 0 : stored->revision;
  const std::uint32_t known = std::max(last, trashed.empty() ? 0 : trashed.rbegin()->first);
  // A stored object has followed the quarantined ones.
  const std::uint32_t largest =
      stored != nullptr ? known : largest_quarantined(folder_, name, known);
  if (largest < kMaxRevision) return largest + 1;
  // Regular use does not reach this number. A foreign file must not block the name, so the smallest
  // free revision is used.
  std::uint32_t free = 1;
  while (free == last || trashed.count(free) != 0) ++free;
  return free;
}

void LockedFolder::write(const ObjectModel& model, const ObjectModel* keep_old) {
  const auto bytes = encode_object(model);
  const std::string path = folder_.object_file(model.name);
  const std::string in_trash = keep_old == nullptr ? "" : link_to_trash(*keep_old);
  const auto old = stamp_of(path);
  try {
    write_file_atomically(folder_.path, model.name + kObjectFileEnding, bytes);
  } catch (...) {
    // If the new file is already in place, the trash contains the only copy of the old one.
    if (!in_trash.empty() && stamp_of(path) == old) ::unlink(in_trash.c_str());
    throw;
  }
}

// The old file is linked into the trash before it is replaced, so that it exists at all times.
std::string LockedFolder::link_to_trash(const ObjectModel& model, const std::string& ending) {
  make_inner_folder(folder_.trash());
  FolderSync trash_sync(folder_.trash());
  const std::string from = folder_.object_file(model.name);
  const std::string to =
      free_path(folder_.trash() + "/" + model.name + "." + std::to_string(model.revision) + ending,
                kObjectFileEnding);
  if (::link(from.c_str(), to.c_str()) != 0) {
    // File systems without hard links get a copy instead.
    if (errno != EPERM && errno != EOPNOTSUPP && errno != EMLINK)
      throw FileError(to, "cannot keep the old revision: " + errno_text(errno));
    const auto content = read_regular_file(from, PngLimits::kMaxBytes);
    write_file_atomically(folder_.trash(), to.substr(to.find_last_of('/') + 1), content.bytes);
  }
  trash_sync.sync();
  return to;
}

void LockedFolder::discard(const ObjectModel& model) {
  make_inner_folder(folder_.trash());
  FolderSync trash_sync(folder_.trash()), folder_sync(folder_.path);
  rename_path(folder_.object_file(model.name),
              free_path(folder_.trash() + "/" + model.name + "." + std::to_string(model.revision),
                        kObjectFileEnding));
  trash_sync.sync();
  folder_sync.sync();
}

void LockedFolder::rename(const ObjectModel& model, const std::string& new_name) {
  FolderSync folder_sync(folder_.path);
  const std::string in_trash = link_to_trash(model, kRenamedEnding);
  try {
    rename_path(folder_.object_file(model.name), folder_.object_file(new_name));
  } catch (...) {
    ::unlink(in_trash.c_str());
    throw;
  }
  folder_sync.sync();
}

bool LockedFolder::quarantine_unreadable(const std::string& file, const FileStamp& stamp) {
  const std::string path = folder_.path + "/" + file;
  try {
    check_file_name(folder_, file);
    read_object_file(path);
    return false;
  } catch (const ContentError& error) {
    const auto now = stamp_of(path);
    if (!now || !(*now == stamp)) return false;
    quarantine(file, error.reason());
    return true;
  }
}

void LockedFolder::quarantine(const std::string& file, const std::string& reason) {
  make_inner_folder(folder_.quarantine());
  const std::string to = free_path(folder_.quarantine() + "/" + file, "");
  // The reason is written first, so that no quarantined file lacks one.
  const std::string text = reason + "\n";
  write_file_atomically(folder_.quarantine(), to.substr(to.find_last_of('/') + 1) + kReasonEnding,
                        {text.begin(), text.end()});
  FolderSync quarantine_sync(folder_.quarantine()), folder_sync(folder_.path);
  rename_path(folder_.path + "/" + file, to);
  quarantine_sync.sync();
  folder_sync.sync();
}

}  // namespace mbncc::library
