// SPDX-License-Identifier: BSD-3-Clause
// One lesson over the action: images, segmentation, review by the operator, storing.
#pragma once

#include <mbncc_vision/LearnObjectResult.h>

#include <string>

#include "nodelets/learning/lesson_draft.hpp"
#include "nodelets/learning/lesson_feedback.hpp"
#include "nodelets/learning/lesson_images.hpp"
#include "nodelets/learning/lesson_server.hpp"
#include "nodelets/learning/lesson_store.hpp"
#include "nodelets/learning/lesson_tools.hpp"

namespace mbncc::nodelets {

class LessonSession {
 public:
  /// `client` and `tools` must outlive this object.
  LessonSession(LessonClient& client, const LessonTools& tools);

  /// Runs the lesson. Failures due to images, region, operator or library are reported in the
  /// result.
  mbncc_vision::LearnObjectResult run();

 private:
  using Result = mbncc_vision::LearnObjectResult;

  Result teach();
  Result review();
  Result store();

  LessonClient& client_;
  const LessonTools& tools_;
  const mbncc_vision::LearnObjectGoal& goal_;
  const std::string name_;
  LessonFeedback feedback_;
  LessonImages images_;
  LessonDraft draft_;
  LessonStore store_;
};

}  // namespace mbncc::nodelets
