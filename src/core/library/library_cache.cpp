// SPDX-License-Identifier: BSD-3-Clause
#include "library/library_cache.hpp"

#include "library/other_image.hpp"
#include "library/png_codec.hpp"
#include "mbncc/library/object_file.hpp"

namespace mbncc {
namespace {

// Moves an unreadable file to the quarantine; false if this is not permitted.
bool move_to_quarantine(const library::LibraryFolder& folder, const std::string& file) {
  try {
    library::LockedFolder(folder).quarantine_unreadable(file);
    return true;
  } catch (const FileError&) {
    return false;
  }
}

}  // namespace

std::shared_ptr<const LibrarySnapshot> LibraryCache::load(const library::LibraryFolder& folder) {
  auto snapshot = std::make_shared<LibrarySnapshot>();
  std::map<std::string, Entry> entries;
  for (const auto& file : library::object_files(folder)) {
    const auto entry = load_file(folder, file, *snapshot);
    if (!entry) continue;
    if (entry->object)
      snapshot->objects.push_back(entry->object);
    else if (entry->other_image)
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
  const std::string path = folder.path + "/" + file;
  const auto stamp = library::stamp_of(path);
  if (!stamp) return std::nullopt;
  const auto known = entries_.find(file);
  if (known != entries_.end() && known->second.stamp == *stamp) return known->second;
  try {
    library::check_file_name(folder, file);
    const library::FileContent content =
        library::read_regular_file(path, library::PngLimits::kMaxBytes);
    return Entry{content.stamp,
                 std::make_shared<const ObjectModel>(decode_object(content.bytes, path)), "",
                 false};
  } catch (const library::ContentError& error) {
    if (library::is_other_image(path)) return Entry{*stamp, nullptr, "", true};
    if (!move_to_quarantine(folder, file)) return Entry{*stamp, nullptr, error.reason(), false};
    snapshot.quarantined.push_back({file, error.reason(), true});
    return std::nullopt;
  } catch (const FileError& error) {
    if (!library::path_exists(path)) return std::nullopt;
    return Entry{*stamp, nullptr, error.reason(), false};
  }
}

bool LibraryCache::is_stale(const library::LibraryFolder& folder) const {
  const auto files = library::object_files(folder);
  if (files.size() != entries_.size()) return true;
  for (const auto& file : files) {
    const auto known = entries_.find(file);
    const auto stamp = library::stamp_of(folder.path + "/" + file);
    if (known == entries_.end() || !stamp || !(known->second.stamp == *stamp)) return true;
  }
  return false;
}

}  // namespace mbncc
