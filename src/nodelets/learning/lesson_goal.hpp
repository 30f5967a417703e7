// SPDX-License-Identifier: BSD-3-Clause
// Checks a LearnObject goal before the operator moves anything.
#pragma once

#include <mbncc_vision/LearnObjectGoal.h>
#include <mbncc_vision/LearnObjectResult.h>

#include <optional>
#include <string>

#include "mbncc/learning/lesson.hpp"
#include "mbncc/learning/lesson_storage.hpp"
#include "nodelets/library/shared_library.hpp"

namespace mbncc::nodelets {

/// Result that rejects a goal with an invalid name, mode or field; none if the goal is valid.
std::optional<mbncc_vision::LearnObjectResult> check_goal(const mbncc_vision::LearnObjectGoal& goal,
                                                          const LibrarySnapshot& library,
                                                          int max_objects);

/// Result that rejects a valid goal because nothing can be stored now; none if it may start. The
/// write test takes some milliseconds.
std::optional<mbncc_vision::LearnObjectResult> check_storage(const SharedLibrary& library);

/// Treatment of a stored object of the same name, for a goal that passed check_goal().
Storing storing_of(const mbncc_vision::LearnObjectGoal& goal);

/// The name in the goal; if it is "", the first free name object_<n>.
std::string name_for(const mbncc_vision::LearnObjectGoal& goal, const LibrarySnapshot& library);

/// The lesson of a goal, without images and without the region of its object.
Lesson described(const mbncc_vision::LearnObjectGoal& goal, const std::string& name);

}  // namespace mbncc::nodelets
