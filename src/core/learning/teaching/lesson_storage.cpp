// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/lesson_storage.hpp"

#include <algorithm>
#include <stdexcept>

#include "mbncc/label.hpp"
#include "mbncc/library/object_file.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc {
namespace {

constexpr const char* kLeaveOut = "Leave it out, or replace the object by overwrite.";

std::optional<Refusal> check_view_fields(const Lesson& lesson, const ObjectModel& stored) {
  if (lesson.object_height != 0 && lesson.object_height != stored.object_height)
    return Refusal(LearnError::kRegionInvalid,
                   "A further view of '" + stored.name + "' cannot change its height.", kLeaveOut);
  if (lesson.reference)
    return Refusal(LearnError::kRegionInvalid,
                   "A further view of '" + stored.name + "' takes its frame over.", kLeaveOut);
  if (!lesson.label.empty() && lesson.label != stored.label)
    return Refusal(LearnError::kNameInvalid,
                   "A further view of '" + stored.name + "' cannot change its label.", kLeaveOut);
  if (lesson.symmetry && lesson.symmetry != stored.symmetry)
    return Refusal(LearnError::kRegionInvalid,
                   "A further view of '" + stored.name + "' cannot change its symmetry.",
                   kLeaveOut);
  return {};
}

LearnError code_of(const std::exception& failure) {
  if (const auto* name = dynamic_cast<const NameError*>(&failure)) return name->code();
  const bool expected = dynamic_cast<const FileError*>(&failure) != nullptr ||
                        dynamic_cast<const std::invalid_argument*>(&failure) != nullptr;
  return expected ? LearnError::kStorage : LearnError::kInternal;
}

// The default hint of kStorage concerns the folder, not an object that is too large for a file, nor
// an error whose message says after a semicolon what to do.
std::string hint_for(const std::exception& failure) {
  const LearnError code = code_of(failure);
  if (code != LearnError::kStorage) return hint_of(code);
  if (const auto* file = dynamic_cast<const FileError*>(&failure))
    return file->reason().find("; ") == std::string::npos ? hint_of(code) : "";
  return "Teach fewer or smaller views, or replace the object by overwrite; the library itself is "
         "unchanged.";
}

}  // namespace

Refusal::Refusal(LearnError error, const std::string& message, const std::string& hint)
    : error(error),
      message(message.empty() ? message_of(error) : message),
      hint(hint.empty() ? hint_of(error) : hint) {}

Refusal::Refusal(const std::exception& failure)
    : error(code_of(failure)),
      message(std::string(failure.what()) + "."),
      hint(hint_for(failure)) {}

std::optional<Refusal> check_storing(const Lesson& lesson, Storing storing,
                                     const LibrarySnapshot& library) {
  if (!is_valid_name(lesson.name)) return Refusal(LearnError::kNameInvalid);
  if (!is_valid_label(lesson.label))
    return Refusal(LearnError::kNameInvalid, "The label is not usable.",
                   "Give printable UTF-8 of at most 200 bytes.");
  const auto& others = library.other_images;
  if (std::find(others.begin(), others.end(), lesson.name + kObjectFileEnding) != others.end())
    return Refusal(LearnError::kNameTaken,
                   "An image that is not an object has this name in the library's folder.",
                   "Choose another name, or move the image away.");
  const auto stored = library.find(lesson.name);
  if (stored && storing == Storing::kNew)
    return Refusal(LearnError::kNameTaken, "The library already holds '" + lesson.name + "'.");
  if (storing != Storing::kAddView) return {};
  if (!stored)
    return Refusal(LearnError::kNameUnknown, "The library does not hold '" + lesson.name + "'.");
  return check_view_fields(lesson, *stored);
}

}  // namespace mbncc
