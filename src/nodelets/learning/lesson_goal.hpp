// SPDX-License-Identifier: BSD-3-Clause
// What a LearnObject goal asks for: checked before the operator moves anything, then put together
// with pictures.
#pragma once

#include <mbncc_vision/LearnObjectGoal.h>
#include <mbncc_vision/LearnObjectResult.h>

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "mbncc/learning/learn_object.hpp"
#include "mbncc/learning/lesson_storage.hpp"
#include "nodelets/library/shared_library.hpp"

namespace mbncc::nodelets {

/// Why the goal must be rejected: name, mode or fields that cannot succeed. None: it may start.
std::optional<mbncc_vision::LearnObjectResult> check_goal(const mbncc_vision::LearnObjectGoal& goal,
                                                          const LibrarySnapshot& library,
                                                          int max_objects);

/// Why the goal must be rejected although it is sound: nothing can be stored now. None: it may
/// start. Takes some milliseconds, as it writes.
std::optional<mbncc_vision::LearnObjectResult> check_storage(const SharedLibrary& library);

/// What a goal that check_goal() let pass does about a stored object of its name.
Storing storing_of(const mbncc_vision::LearnObjectGoal& goal);

/// The goal's name, or the first free object_<n> for "".
std::string name_for(const mbncc_vision::LearnObjectGoal& goal, const LibrarySnapshot& library);

/// The lesson of a goal that check_goal() let pass, shown by these pictures (CV_8UC3; `after`
/// empty where the mode needs none). On failure `fault` holds the result to end with.
struct GoalLesson {
  Lesson lesson;
  std::optional<mbncc_vision::LearnObjectResult> fault;
};
GoalLesson to_lesson(const mbncc_vision::LearnObjectGoal& goal, const std::string& name,
                     const cv::Mat& before, const cv::Mat& after);

}  // namespace mbncc::nodelets
