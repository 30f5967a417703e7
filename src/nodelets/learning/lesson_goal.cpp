// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/lesson_goal.hpp"

#include <cmath>
#include <stdexcept>

#include "nodelets/conversion/images.hpp"
#include "nodelets/conversion/messages.hpp"
#include "nodelets/learning/outcome.hpp"

namespace mbncc::nodelets {
namespace {

using Goal = mbncc_vision::LearnObjectGoal;
using Fault = std::optional<mbncc_vision::LearnObjectResult>;

constexpr double kLongestLesson = 86400;  // [s] longer timeouts are refused

bool is_empty(const sensor_msgs::RegionOfInterest& roi) {
  return roi.width == 0 && roi.height == 0;
}

Fault check_symmetry(const Goal& goal) {
  try {
    symmetry_from_msg(goal.symmetry);
  } catch (const std::invalid_argument&) {
    return outcome(LearnError::kRegionInvalid,
                   "The symmetry " + std::to_string(goal.symmetry) + " does not exist.",
                   "Give SYMMETRY_AUTO, _NONE, _ROUND, or a number of equal angles from 2 to 12.");
  }
  return {};
}

Fault check_storable(const Goal& goal, const LibrarySnapshot& library, int max_objects) {
  if (goal.overwrite && goal.add_view)
    return outcome(LearnError::kNameTaken, "Both overwrite and add_view are set.",
                   "Set one of them: overwrite replaces the object, add_view adds an image.");
  const Lesson lesson = described(goal, goal.add_view ? goal.name : name_for(goal, library));
  if (const auto refusal = check_storing(lesson, storing_of(goal), library))
    return outcome(*refusal);
  if (!library.find(lesson.name) && library.objects.size() >= static_cast<std::size_t>(max_objects))
    return outcome(LearnError::kStorage,
                   "The library holds " + std::to_string(max_objects) + " objects, its limit.",
                   "Delete objects, or raise max_objects.");
  return {};
}

Fault check_mode(const Goal& goal) {
  switch (goal.mode) {
    case Goal::CHANGE:
      return {};
    case Goal::ROI:
      if (!is_empty(goal.roi)) return {};
      return outcome(LearnError::kRegionInvalid, "Mode ROI needs a region, but roi is 0 x 0.");
    case Goal::OUTLINE:
      if (goal.outline.points.size() >= 3) return {};
      return outcome(LearnError::kRegionInvalid, "Mode OUTLINE needs three corners or more.");
    case Goal::MASK:
      if (is_given(goal.mask)) return {};
      return outcome(LearnError::kRegionInvalid, "Mode MASK needs a mask, but it is empty.");
    case Goal::CLICK:
      if (std::isfinite(goal.point.x) && std::isfinite(goal.point.y)) return {};
      return outcome(LearnError::kRegionInvalid, "Mode CLICK needs a point, but it is not finite.");
    default:
      return outcome(LearnError::kRegionInvalid,
                     "Mode " + std::to_string(goal.mode) + " does not exist.",
                     "Give CHANGE, ROI, OUTLINE, MASK or CLICK.");
  }
}

Fault check_numbers(const Goal& goal) {
  if (!(goal.object_height >= 0 && goal.object_height <= kLongestLength))
    return outcome(LearnError::kRegionInvalid, "The object's height is not in 0 .. 10 m.",
                   "Give object_height in metres, 0 for a flat object.");
  if (goal.set_reference && !from_msg(goal.reference))
    return outcome(LearnError::kRegionInvalid, "The reference must be finite and within 32768 px.",
                   "Give reference x, y [px] and theta [rad], or leave set_reference false.");
  if (!from_msg(goal.outline))
    return outcome(LearnError::kRegionInvalid, "A corner of the outline is not finite.");
  if (goal.timeout.toSec() < 0 || goal.timeout.toSec() > kLongestLesson)
    return outcome(LearnError::kTimeout, "The timeout is not in 0 .. 86400 s.",
                   "Set a timeout of at most 86400 s, or 0 for the configured one.");
  return {};
}

}  // namespace

Lesson described(const Goal& goal, const std::string& name) {
  Lesson lesson;
  lesson.name = name;
  lesson.label = goal.label;
  lesson.object_height = goal.object_height;
  lesson.symmetry = symmetry_from_msg(goal.symmetry);
  if (goal.set_reference) lesson.reference = from_msg(goal.reference);
  return lesson;
}

Fault check_goal(const Goal& goal, const LibrarySnapshot& library, int max_objects) {
  if (auto fault = check_symmetry(goal)) return fault;
  if (auto fault = check_storable(goal, library, max_objects)) return fault;
  if (auto fault = check_mode(goal)) return fault;
  return check_numbers(goal);
}

Fault check_storage(const SharedLibrary& library) {
  try {
    library.check_storage();
    return {};
  } catch (const FileError& failure) {
    return outcome(Refusal(failure));
  }
}

Storing storing_of(const Goal& goal) {
  if (goal.add_view) return Storing::kAddView;
  return goal.overwrite ? Storing::kReplace : Storing::kNew;
}

std::string name_for(const Goal& goal, const LibrarySnapshot& library) {
  if (!goal.name.empty()) return goal.name;
  std::size_t number = 1;
  while (library.find("object_" + std::to_string(number))) ++number;
  return "object_" + std::to_string(number);
}

}  // namespace mbncc::nodelets
