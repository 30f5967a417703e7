// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/library/shared_library.hpp"

#include <utility>

#include "mbncc/home_folder.hpp"

namespace mbncc::nodelets {

SharedLibrary::SharedLibrary(const std::string& path, Listener listener)
    : library_(expand_home(path)), listener_(std::move(listener)) {
  refresh(true);
}

SharedLibrary::Snapshot SharedLibrary::snapshot() const {
  const std::lock_guard<std::mutex> lock(snapshot_mutex_);
  return snapshot_;
}

void SharedLibrary::refresh(bool always) {
  const std::lock_guard<std::mutex> lock(library_mutex_);
  try {
    if (always || !handed_over_ || library_.changed_on_disk()) load();
    note("");
  } catch (const std::exception& error) {
    note_unreadable(error);
    throw;
  }
}

void SharedLibrary::note(const std::string& fault) {
  const std::lock_guard<std::mutex> lock(snapshot_mutex_);
  fault_ = fault;
}

void SharedLibrary::note_unreadable(const std::exception& error) {
  note(std::string("the library cannot be read: ") + error.what());
}

std::string SharedLibrary::fault() const {
  const std::lock_guard<std::mutex> lock(snapshot_mutex_);
  return fault_;
}

void SharedLibrary::check_storage() const {
  const std::lock_guard<std::mutex> lock(library_mutex_);
  library_.check_storage();
}

ObjectModel SharedLibrary::change(const std::function<ObjectModel(ObjectLibrary&)>& change) {
  const std::lock_guard<std::mutex> lock(library_mutex_);
  handed_over_ = false;  // a change that fails may have read what others have changed
  const ObjectModel changed = change(library_);
  try {
    load();
  } catch (const std::exception& error) {
    // The change is made; to repeat it would fail. The next refresh() reads it.
    note_unreadable(error);
  }
  return changed;
}

void SharedLibrary::load() {
  handed_over_ = false;
  const Snapshot fresh = library_.load();
  {
    const std::lock_guard<std::mutex> lock(snapshot_mutex_);
    snapshot_ = fresh;
  }
  listener_(fresh);
  handed_over_ = true;
}

}  // namespace mbncc::nodelets
