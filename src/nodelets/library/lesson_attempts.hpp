// SPDX-License-Identifier: BSD-3-Clause
// Stores the object of one lesson, as often as the operator accepts it: an attempt can fail
// although the object is in place already, for example if its folder cannot be synced to the disk.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "mbncc/library/object_library.hpp"

namespace mbncc::nodelets {

class LessonAttempts {
 public:
  /// Stores a new object, or one that replaces another. What an earlier attempt of this lesson has
  /// stored does not count as existing. Throws like ObjectLibrary::save().
  ObjectModel save(ObjectLibrary& library, ObjectModel model, ObjectLibrary::Existing existing);

  /// Changes the stored object by `add`, which appends a view; that of an earlier attempt is
  /// removed first. Throws like ObjectLibrary::edit().
  ObjectModel add_view(ObjectLibrary& library, const std::string& name,
                       const std::function<void(ObjectModel&)>& add);

 private:
  bool has_stored(ObjectLibrary& library, const ObjectModel& model) const;

  std::optional<double> learned_at_;  // of the object since the first attempt
  std::optional<View> view_;          // that an attempt has added
};

}  // namespace mbncc::nodelets
