// SPDX-License-Identifier: BSD-3-Clause
// The operator's review of a draft before it is stored: accept, reject, edit, undo.
#pragma once

#include "nodelets/learning/confirmation.hpp"
#include "nodelets/learning/lesson_draft.hpp"
#include "nodelets/learning/lesson_feedback.hpp"

namespace mbncc::nodelets {

/// Accepts commands while it exists; a call that is pending at its end is refused.
class LessonReview {
 public:
  /// The references outlive it. `further_view`: the frame is the stored object's.
  LessonReview(Confirmation& desk, LessonDraft& draft, LessonFeedback& feedback, cv::Size image,
               bool further_view);
  ~LessonReview();

  /// Carries out edits until the operator accepts what may be stored (true) or rejects (false). The
  /// call that decided then waits for answer().
  bool is_accepted();

  void answer(bool success, const std::string& message);

 private:
  Confirmation::Request next_command();
  void carry_out(const Confirmation::Request& command);
  void edit(const Confirmation::Request& command);

  Confirmation& desk_;
  LessonDraft& draft_;
  LessonFeedback& feedback_;
  const cv::Size image_;
  const bool further_view_;
};

}  // namespace mbncc::nodelets
