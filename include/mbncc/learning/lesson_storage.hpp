// SPDX-License-Identifier: BSD-3-Clause
// What a lesson may do to the library: checked before the operator moves anything, and a further
// view of a known object made part of it.
#pragma once

#include <exception>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "mbncc/config/search_config.hpp"
#include "mbncc/error.hpp"
#include "mbncc/learning/learn_object.hpp"
#include "mbncc/library/object_library.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Why a lesson is not stored.
struct Refusal {
  LearnError error = LearnError::kInternal;
  std::string message;  ///< what happened, one sentence
  std::string hint;     ///< what to do about it, one sentence

  /// Texts left out are the usual ones of `error`.
  explicit Refusal(LearnError error, const std::string& message = "", const std::string& hint = "");

  /// What an exception of the library says to whoever taught.
  explicit Refusal(const std::exception& failure);
};

/// What a lesson does about a stored object of its name.
enum class Storing {
  kNew,      ///< there must be none
  kReplace,  ///< it is replaced, if there is one
  kAddView   ///< there must be one; the lesson's picture becomes a further view of it
};

/// Why a lesson of this name, label, height, symmetry and reference cannot be stored; none: it may
/// start. A further view brings nothing of its own but the picture: the rest is the stored
/// object's.
std::optional<Refusal> check_storing(const Lesson& lesson, Storing storing,
                                     const LibrarySnapshot& library);

/// Makes the view of `learned`, taught by `picture`, a further one of `stored`, in its frame and at
/// its height; the verdict is that of the newest view. Refuses, and leaves `stored` as it was, when
/// the stored object is not found in the picture.
std::optional<Refusal> add_view(ObjectModel& stored, const ObjectModel& learned,
                                const cv::Mat& picture, const SearchConfig& search = {});

}  // namespace mbncc
