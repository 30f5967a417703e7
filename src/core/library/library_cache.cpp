// SPDX-License-Identifier: BSD-3-Clause
#include "library/library_cache.hpp"

#include "library/other_image.hpp"
#include "library/png_codec.hpp"
#include "mbncc/library/object_file.hpp"

namespace mbncc {

std::shared_ptr<const LibrarySnapshot> LibraryCache::load(const library::LibraryFolder& folder) {
  auto snapshot = std::make_shared<LibrarySnapshot>();
  std::map<std::string, Entry> entries;
  for (const auto& file : library::object_files(folder)) {
    const auto entry = load_file(folder, file, *snapshot);
    if (!entry) continue;
    if (entry->state == State::kObject)
      snapshot->objects.push_back(entry->object);
    else if (entry->state == State::kOtherImage)
      snapshot->other_images.push_back(file);
    else
      snapshot->quarantined.push_back({file, entry->reason, false});
    entries[file] = *entry;
  }
  entries_ = std::move(entries);
  return snapshot;
}

// Returns none if another writer has removed the file or it was moved to the quarantine.
std::optional<LibraryCache::Entry> LibraryCache::load_file(const library::LibraryFolder& folder,
                                                           const std::string& file,
                                                           LibrarySnapshot& snapshot) const {
  const auto stamp = library::stamp_of(folder.path + "/" + file);
  if (!stamp) return std::nullopt;
  const auto known = entries_.find(file);
  const bool is_known = known != entries_.end() && known->second.stamp == *stamp &&
                        known->second.state != State::kUncertain;
  if (is_known) return known->second;
  const Entry entry = read(folder, file, *stamp);
  if (entry.state == State::kUncertain && !library::path_exists(folder.path + "/" + file))
    return std::nullopt;
  if (entry.state != State::kDamaged) return entry;
  try {
    const bool moved = library::LockedFolder(folder).quarantine_unreadable(file, *stamp);
    if (!moved) return read(folder, file, *stamp);  // another program has changed it meanwhile
  } catch (const FileError&) {
    return entry;  // moving it is not permitted
  }
  snapshot.quarantined.push_back({file, entry.reason, true});
  return std::nullopt;
}

LibraryCache::Entry LibraryCache::read(const library::LibraryFolder& folder,
                                       const std::string& file, const library::FileStamp& stamp) {
  const std::string path = folder.path + "/" + file;
  try {
    library::check_file_name(folder, file);
    const auto content = library::read_regular_file(path, library::PngLimits::kMaxBytes);
    auto object = std::make_shared<const ObjectModel>(decode_object(content.bytes, path));
    return {content.stamp, State::kObject, "", std::move(object)};
  } catch (const library::ContentError& error) {
    if (library::is_other_image(path)) return {stamp, State::kOtherImage, "", nullptr};
    if (library::changed_recently(stamp))
      return {stamp, State::kUncertain, error.reason() + " (it may still be being copied)",
              nullptr};
    return {stamp, State::kDamaged, error.reason(), nullptr};
  } catch (const library::NewerFileError& error) {
    return {stamp, State::kNewer, error.reason(), nullptr};
  } catch (const FileError& error) {
    return {stamp, State::kUncertain, error.reason(), nullptr};
  }
}

bool LibraryCache::is_stale(const library::LibraryFolder& folder) const {
  const auto files = library::object_files(folder);
  if (files.size() != entries_.size()) return true;
  for (const auto& file : files) {
    const auto known = entries_.find(file);
    const auto stamp = library::stamp_of(folder.path + "/" + file);
    if (known == entries_.end() || !stamp || !(known->second.stamp == *stamp)) return true;
    if (known->second.state == State::kUncertain &&
        read(folder, file, *stamp).state != State::kUncertain)
      return true;
  }
  return false;
}

}  // namespace mbncc
