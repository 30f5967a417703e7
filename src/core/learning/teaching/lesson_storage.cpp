// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/lesson_storage.hpp"

#include <algorithm>
#include <stdexcept>

#include "mbncc/label.hpp"
#include "mbncc/learning/resemblance.hpp"
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

// The default hint of kStorage concerns the folder, not an object that is too large for a file.
std::string hint_for(const std::exception& failure) {
  const LearnError code = code_of(failure);
  if (code != LearnError::kStorage || dynamic_cast<const FileError*>(&failure) != nullptr)
    return hint_of(code);
  return "Teach fewer or smaller views, or replace the object by overwrite; the library itself is "
         "unchanged.";
}

/// The object lies as in a stored view, in the same light, so the view adds nothing.
bool shows_the_same(const View& one, const View& other) {
  constexpr double kSameMap = 0.9;  // of the larger map
  constexpr double kNoise = 4;      // [grey levels] mean difference of two images of one scene
  const cv::Rect place(one.origin, one.map.size()), other_place(other.origin, other.map.size());
  const cv::Rect common = place & other_place;
  if (one.image_size != other.image_size || common.empty()) return false;
  const cv::Rect here = common - one.origin, there = common - other.origin;
  const cv::Mat both = one.map(here) & other.map(there);
  const int larger = std::max(cv::countNonZero(one.map), cv::countNonZero(other.map));
  if (cv::countNonZero(both) < kSameMap * larger) return false;
  cv::Mat difference;
  cv::absdiff(one.template_image(here), other.template_image(there), difference);
  const cv::Scalar mean = cv::mean(difference, both);
  return std::max({mean[0], mean[1], mean[2]}) < kNoise;
}

}  // namespace

Refusal::Refusal(LearnError error, const std::string& message, const std::string& hint)
    : error(error),
      message(message.empty() ? message_of(error) : message),
      hint(hint.empty() ? hint_of(error) : hint) {}

Refusal::Refusal(const std::exception& failure)
    : Refusal(code_of(failure), std::string(failure.what()) + ".", hint_for(failure)) {}

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

std::optional<Refusal> add_view(ObjectModel& stored, const ObjectModel& learned,
                                const cv::Mat& image, const SearchConfig& search) {
  View view = learned.views.front();
  for (const auto& known : stored.views)
    if (shows_the_same(view, known))
      return Refusal(
          LearnError::kAlreadyKnown,
          "'" + stored.name + "' already has this view: the object lies as in that image.",
          "Turn the object a little or change the light; then teach the view again. Another side "
          "is taught under its own name.");
  const auto reference = shared_reference(stored, view, image, search);
  if (!reference)
    return Refusal(LearnError::kNotDistinct,
                   "The stored object was not found in the new image, so the new view cannot "
                   "share its frame.",
                   "A further view shows the same side, turned a little or in other light. Teach "
                   "another side under its own name, or use overwrite.");
  view.reference = *reference;
  stored.views.push_back(view);
  stored.quality = learned.quality;
  declare_symmetry(stored, stored.symmetry);
  return {};
}

void note_refused_view(ObjectModel& learned, const ObjectModel& stored, const cv::Mat& image,
                       const SearchConfig& search) {
  ObjectModel tried = stored;
  const auto refusal = add_view(tried, learned, image, search);
  if (!refusal) return;
  Quality& quality = learned.quality;
  quality.verdict = Verdict::kBad;
  quality.reasons.insert(quality.reasons.begin(), "view_refused");
  quality.advice.insert(quality.advice.begin(),
                        "It cannot be added. " + refusal->message + " " + refusal->hint);
}

}  // namespace mbncc
