// SPDX-License-Identifier: BSD-3-Clause
// Checks a LearnObject goal before the operator moves anything.
#pragma once

#include <mbncc_vision/LearnObjectGoal.h>
#include <mbncc_vision/LearnObjectResult.h>

#include <optional>
#include <string>

#include "mbncc/learning/learn_object.hpp"
#include "mbncc/learning/lesson_storage.hpp"
#include "nodelets/library/shared_library.hpp"

namespace mbncc::nodelets {

/// Why the goal must be rejected: invalid name, mode or fields. None: it may start.
std::optional<mbncc_vision::LearnObjectResult> check_goal(const mbncc_vision::LearnObjectGoal& goal,
                                                          const LibrarySnapshot& library,
                                                          int max_objects);

/// Why a valid goal must be rejected: nothing can be stored now. None: it may start. Takes some
/// milliseconds for a write test.
std::optional<mbncc_vision::LearnObjectResult> check_storage(const SharedLibrary& library);

/// Treatment of a stored object of the same name, for a goal that passed check_goal().
Storing storing_of(const mbncc_vision::LearnObjectGoal& goal);

/// The goal's name, or the first free object_<n> for "".
std::string name_for(const mbncc_vision::LearnObjectGoal& goal, const LibrarySnapshot& library);

/// The goal's lesson, without images and without the place of its object.
Lesson described(const mbncc_vision::LearnObjectGoal& goal, const std::string& name);

}  // namespace mbncc::nodelets
