// SPDX-License-Identifier: BSD-3-Clause
// What the parts of a lesson have in common: its stages' places in the progress, and its early end.
#pragma once

#include <mbncc_vision/LearnObjectResult.h>

namespace mbncc::nodelets {

/// Progress of a whole lesson at the end of taking pictures, of learning, of the operator's check.
constexpr double kTaken = 0.3, kLearned = 0.9, kChecked = 0.95;

/// Leaves a lesson from any depth of it; caught in LessonRun::run() alone.
struct LessonEnded {
  mbncc_vision::LearnObjectResult result;
};

}  // namespace mbncc::nodelets
