// SPDX-License-Identifier: BSD-3-Clause
// Shared by the parts of a lesson: the progress of its stages, and its early end.
#pragma once

#include <mbncc_vision/LearnObjectResult.h>

namespace mbncc::nodelets {

/// Progress of a whole lesson at the end of taking images, of learning, of the operator's check.
constexpr double kTaken = 0.3, kLearned = 0.9, kChecked = 0.95;

/// Ends a lesson from any depth; caught only in LessonRun::run().
struct LessonEnded {
  mbncc_vision::LearnObjectResult result;
};

}  // namespace mbncc::nodelets
