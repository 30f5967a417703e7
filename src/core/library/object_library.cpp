// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/library/object_library.hpp"

#include <sys/stat.h>

#include <algorithm>

#include "library/library_cache.hpp"
#include "library/library_folder.hpp"
#include "library/model_difference.hpp"
#include "mbncc/library/object_file.hpp"

namespace mbncc {
namespace {

[[noreturn]] void refuse_unknown(const std::string& name) {
  throw NameError(LearnError::kNameUnknown, "the library has no object '" + name + "'");
}

[[noreturn]] void refuse_missing(const library::LibraryFolder& folder, const std::string& name,
                                 std::uint32_t revision,
                                 const std::map<std::uint32_t, std::string>& revisions) {
  std::string known;
  for (const auto& [number, path] : revisions)
    known += (known.empty() ? "" : ", ") + std::to_string(number);
  throw NameError(LearnError::kNameUnknown,
                  revisions.empty() ? "the trash has no object '" + name +
                                          "'; its objects are the files of " + folder.trash()
                                    : "the trash has no revision " + std::to_string(revision) +
                                          " of '" + name + "'; it has " + known);
}

void refuse_taken(const library::LibraryFolder& folder, const std::string& name) {
  if (!library::path_exists(folder.object_file(name))) return;
  library::refuse_other_image(folder.object_file(name));
  throw NameError(LearnError::kNameTaken, "the library has an object '" + name + "' already");
}

void refuse_invalid(const std::string& name) {
  if (!is_valid_name(name))
    throw NameError(LearnError::kNameInvalid, "the name '" + name +
                                                  "' is not allowed; give a letter, then letters, "
                                                  "digits or underscores, 64 characters at most");
}

/// The newest readable one of these revisions.
ObjectModel read_newest(const std::map<std::uint32_t, std::string>& revisions) {
  for (auto revision = revisions.rbegin(); std::next(revision) != revisions.rend(); ++revision) {
    try {
      return read_object_file(revision->second);
    } catch (const library::ContentError&) {  // try an older revision
    }
  }
  return read_object_file(revisions.begin()->second);
}

std::unique_ptr<ObjectModel> read_known(library::LockedFolder& locked, const std::string& name) {
  auto stored = locked.read(name);
  if (!stored) refuse_unknown(name);
  return stored;
}

}  // namespace

std::uint64_t folder_inode(const std::string& folder) {
  struct stat status {};
  return ::stat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) ? status.st_ino : 0;
}

ObjectLibrary::ObjectLibrary(std::string folder)
    : folder_(std::move(folder)), cache_(std::make_unique<LibraryCache>()) {
  if (folder_.empty()) throw FileError("''", "a library needs a folder");
  library::make_folder(folder_);
}

ObjectLibrary::~ObjectLibrary() = default;
ObjectLibrary::ObjectLibrary(ObjectLibrary&&) noexcept = default;
ObjectLibrary& ObjectLibrary::operator=(ObjectLibrary&&) noexcept = default;

std::shared_ptr<const LibrarySnapshot> ObjectLibrary::load() {
  return cache_->load({folder_});
}

bool ObjectLibrary::changed_on_disk() const {
  return cache_->is_stale({folder_});
}

void ObjectLibrary::check_storage() const {
  library::check_storage({folder_});
}

std::vector<QuarantinedFile> ObjectLibrary::quarantine() const {
  return library::quarantined_files({folder_});
}

bool ObjectLibrary::trashed_since(const std::string& name, const QuarantinedFile& file) const {
  return library::trashed_since({folder_}, name, file);
}

ObjectModel ObjectLibrary::save(ObjectModel model, Existing existing) {
  validate(model);
  library::LockedFolder locked({folder_});
  if (existing == Existing::kRefuse) refuse_taken({folder_}, model.name);
  const auto old = locked.read(model.name);
  model.revision = locked.next_revision(model.name, old.get());
  locked.write(model, old.get());
  return model;
}

ObjectModel ObjectLibrary::edit(const std::string& name,
                                const std::function<void(ObjectModel&)>& change) {
  library::LockedFolder locked({folder_});
  const auto old = read_known(locked, name);
  ObjectModel model = library::deep_copy(*old);
  change(model);
  model.name = name;
  const bool new_revision = library::moves_poses(*old, model);
  model.revision = new_revision ? locked.next_revision(name, old.get()) : old->revision;
  locked.write(model, new_revision ? old.get() : nullptr);
  return model;
}

// Two atomic steps: first the description under the old name, then the name.
ObjectModel ObjectLibrary::rename(const std::string& name, const std::string& new_name,
                                  const std::string& label) {
  library::LockedFolder locked({folder_});
  ObjectModel model = *read_known(locked, name);
  const bool moves = !new_name.empty() && new_name != name;
  if (moves) {
    refuse_invalid(new_name);
    refuse_taken({folder_}, new_name);
    model.revision = std::max(model.revision, locked.next_revision(new_name, nullptr));
  }
  if (!label.empty()) model.label = label;
  locked.write(model, nullptr);
  if (moves) {
    locked.rename(model, new_name);
    model.name = new_name;
  }
  return model;
}

ObjectModel ObjectLibrary::remove(const std::string& name) {
  library::LockedFolder locked({folder_});
  const auto removed = read_known(locked, name);
  locked.discard(*removed);
  return *removed;
}

ObjectModel ObjectLibrary::restore(const std::string& name, std::uint32_t revision) {
  refuse_invalid(name);
  library::LockedFolder locked({folder_});
  const auto revisions = library::trashed_revisions({folder_}, name);
  auto removed = revisions;  // what a rename left is another object by now
  for (auto one = removed.begin(); one != removed.end();)
    one = library::is_left_by_rename(one->second) ? removed.erase(one) : std::next(one);
  if (revision != 0 ? revisions.count(revision) == 0 : removed.empty())
    refuse_missing({folder_}, name, revision, revisions);
  ObjectModel model =
      revision != 0 ? read_object_file(revisions.at(revision)) : read_newest(removed);
  const auto old = locked.read(name);
  model.revision = locked.next_revision(name, old.get());
  locked.write(model, old.get());
  return model;
}

}  // namespace mbncc
