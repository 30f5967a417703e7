// SPDX-License-Identifier: BSD-3-Clause
// Checks whether a lesson may be stored, before the operator moves anything.
#pragma once

#include <exception>
#include <optional>
#include <string>

#include "mbncc/error.hpp"
#include "mbncc/learning/lesson.hpp"
#include "mbncc/library/object_library.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Why a lesson is not stored.
struct Refusal {
  LearnError error = LearnError::kInternal;
  std::string message;  ///< what happened, one sentence
  std::string hint;     ///< what to do about it, one sentence; "": the message says it

  /// Empty texts are replaced by those of `error`.
  explicit Refusal(LearnError error, const std::string& message = "", const std::string& hint = "");

  /// Converts an exception of the library into a refusal.
  explicit Refusal(const std::exception& failure);
};

/// Treatment of a stored object of the same name.
enum class Storing {
  kNew,      ///< there must be none
  kReplace,  ///< it is replaced, if there is one
  kAddView   ///< there must be one; the lesson's image becomes its further view
};

/// Why a lesson of this name, label, height, symmetry and reference cannot be stored; none if it
/// may start. A further view provides only the image; all other values are those of the stored
/// object.
std::optional<Refusal> check_storing(const Lesson& lesson, Storing storing,
                                     const LibrarySnapshot& library);

}  // namespace mbncc
