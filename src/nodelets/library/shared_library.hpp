// SPDX-License-Identifier: BSD-3-Clause
// The library shared by one nodelet's threads: one open folder, one current snapshot.
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "mbncc/library/object_library.hpp"

namespace mbncc::nodelets {

class SharedLibrary {
 public:
  using Snapshot = std::shared_ptr<const LibrarySnapshot>;
  /// Receives every new snapshot, including the first; called on the thread that loaded it, one at
  /// a time.
  using Listener = std::function<void(const Snapshot&)>;

  /// Opens and reads the folder. Throws FileError.
  SharedLibrary(const std::string& path, Listener listener);

  const std::string& folder() const { return library_.folder(); }
  Snapshot snapshot() const;

  /// Reads the folder again if a file has changed or the last attempt failed, or in any case if
  /// `always`. Throws FileError, and what the listener throws.
  void refresh(bool always);

  /// Why the last attempt to read the folder failed; "" if it succeeded.
  std::string fault() const;

  /// See ObjectLibrary::check_storage().
  void check_storage() const;

  /// Runs `change` on the library, then reads it again; if that fails, fault() tells. Throws what
  /// `change` throws.
  ObjectModel change(const std::function<ObjectModel(ObjectLibrary&)>& change);

 private:
  void load();
  void note(const std::string& fault);
  void note_unreadable(const std::exception& error);

  mutable std::mutex snapshot_mutex_;
  mutable std::mutex library_mutex_;  // locked before snapshot_mutex_
  ObjectLibrary library_;
  Snapshot snapshot_;
  std::string fault_;         // guarded by snapshot_mutex_
  bool handed_over_ = false;  // the folder's last state, to listener_; guarded by library_mutex_
  const Listener listener_;
};

}  // namespace mbncc::nodelets
