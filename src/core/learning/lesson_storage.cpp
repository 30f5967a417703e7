#include "mbncc/learning/lesson_storage.hpp"

#include "mbncc/learning/resemblance.hpp"

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
  return {};
}

}  // namespace

Refusal::Refusal(LearnError error, const std::string& message, const std::string& hint)
    : error(error),
      message(message.empty() ? message_of(error) : message),
      hint(hint.empty() ? hint_of(error) : hint) {}

std::optional<Refusal> check_storing(const Lesson& lesson, Storing storing,
                                     const LibrarySnapshot& library) {
  if (!is_valid_name(lesson.name)) return Refusal(LearnError::kNameInvalid);
  const auto stored = library.find(lesson.name);
  if (stored && storing == Storing::kNew)
    return Refusal(LearnError::kNameTaken, "The library already holds '" + lesson.name + "'.");
  if (storing != Storing::kAddView) return {};
  if (!stored)
    return Refusal(LearnError::kNameUnknown, "The library does not hold '" + lesson.name + "'.");
  return check_view_fields(lesson, *stored);
}

std::optional<Refusal> add_view(ObjectModel& stored, const ObjectModel& learned,
                                const cv::Mat& picture, const SearchConfig& search) {
  View view = learned.views.front();
  const auto reference = shared_reference(stored, view, picture, search);
  if (!reference)
    return Refusal(LearnError::kNotDistinct,
                   "The stored object was not found in the new picture, so the new view cannot "
                   "share its frame.",
                   "Show it more like the stored views, or use overwrite.");
  view.reference = *reference;
  stored.views.push_back(view);
  stored.quality = learned.quality;
  return {};
}

}  // namespace mbncc
