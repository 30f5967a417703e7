// SPDX-License-Identifier: BSD-3-Clause
// The contents of a library at the time it was read.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mbncc/object_model.hpp"

namespace mbncc {

/// A file that could not be read.
struct QuarantinedFile {
  std::string file;    ///< name within the library folder
  std::string reason;  ///< one sentence
  bool moved = true;   ///< to `.quarantine/`; false: left in place (no permission, a newer format,
                       ///< changed in the last seconds, or an error unrelated to its content)
};

/// Immutable snapshot of a library; may be shared between threads.
struct LibrarySnapshot {
  std::vector<std::shared_ptr<const ObjectModel>> objects;  ///< sorted by name
  std::vector<QuarantinedFile> quarantined;                 ///< by this load
  std::vector<std::string> other_images;  ///< PNG files that are not objects; they stay in place

  std::shared_ptr<const ObjectModel> find(const std::string& name) const;  ///< null: unknown
};

}  // namespace mbncc
