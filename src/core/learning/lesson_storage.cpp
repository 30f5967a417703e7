#include "mbncc/learning/lesson_storage.hpp"

#include "mbncc/learning/resemblance.hpp"

namespace mbncc {
Refusal::Refusal(LearnError error, const std::string& message, const std::string& hint)
    : error(error),
      message(message.empty() ? message_of(error) : message),
      hint(hint.empty() ? hint_of(error) : hint) {}

std::optional<Refusal> check_storing(const std::string& name, Storing storing,
                                     const LibrarySnapshot& library) {
  if (!is_valid_name(name)) return Refusal(LearnError::kNameInvalid);
  const auto stored = library.find(name);
  if (stored && storing == Storing::kNew)
    return Refusal(LearnError::kNameTaken, "The library already holds '" + name + "'.");
  if (!stored && storing == Storing::kAddView)
    return Refusal(LearnError::kNameUnknown, "The library does not hold '" + name + "'.");
  return {};
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
