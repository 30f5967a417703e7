// SPDX-License-Identifier: BSD-3-Clause
// The operator's review of a draft before it is stored: accept, reject, edit, undo.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "nodelets/learning/confirmation.hpp"
#include "nodelets/learning/lesson_draft.hpp"
#include "nodelets/learning/lesson_feedback.hpp"

namespace mbncc::nodelets {

/// Accepts commands while it exists; a call that is pending at its end is refused.
class LessonReview {
 public:
  /// The references must outlive this object. `goal_id` is that of the lesson, `image` the size
  /// [px] of the learning image. With `further_view`, the object's frame is that of the stored
  /// object and cannot be moved.
  LessonReview(Confirmation& confirmation, const std::string& goal_id, LessonDraft& draft,
               LessonFeedback& feedback, cv::Size image, bool further_view);
  ~LessonReview();

  /// Carries out edits until the operator accepts a draft that may be stored (true) or rejects it
  /// (false). The service call that decided then waits for answer().
  bool is_accepted();

  void answer(bool success, const std::string& message);

 private:
  Confirmation::Request next_command();
  void carry_out(const Confirmation::Request& command);
  void edit(const Confirmation::Request& command);

  Confirmation& confirmation_;
  LessonDraft& draft_;
  LessonFeedback& feedback_;
  const cv::Size image_;
  const bool further_view_;
};

}  // namespace mbncc::nodelets
