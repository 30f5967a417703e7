// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/lesson_session.hpp"

#include <mbncc_vision/LearnObjectFeedback.h>

#include "nodelets/learning/lesson_goal.hpp"
#include "nodelets/learning/lesson_review.hpp"
#include "nodelets/learning/outcome.hpp"

namespace mbncc::nodelets {

LessonSession::LessonSession(LessonClient& client, const LessonTools& tools)
    : client_(client),
      tools_(tools),
      goal_(client.goal()),
      name_(name_for(goal_, *tools.library.snapshot())),
      feedback_(client),
      images_(goal_, tools.images, tools.gauge, feedback_),
      draft_(goal_, name_, tools, images_, feedback_),
      store_(goal_, name_, tools, images_) {}

LessonSession::Result LessonSession::run() {
  try {
    return teach();
  } catch (const LessonEnded& ended) {
    return ended.result;
  }
}

LessonSession::Result LessonSession::teach() {
  images_.take();
  draft_.learn();
  bool overlaps_old_place = draft_.overlaps_old_place();
  // No object has left: the coarse comparison was wrong, or something was put down.
  while ((overlaps_old_place || draft_.learned().error == LearnError::kNoChange) &&
         images_.can_wait_for_next_change()) {
    images_.wait_for_next_change();
    draft_.learn();
    overlaps_old_place = draft_.overlaps_old_place();
  }
  if (overlaps_old_place)
    end_lesson(LearnError::kNoChange, "The object was put down where it covers its old place.",
               "Put it farther away, or take it out of the image.");
  if (goal_.confirm && draft_.learned().has_model) return review();
  return draft_.may_be_stored() ? store() : outcome(draft_.learned(), images_.before());
}

LessonSession::Result LessonSession::review() {
  LessonReview review(tools_.confirmation, client_.goal_id(), draft_, feedback_,
                      images_.before().image.size(), goal_.add_view);
  client_.wait_for_operator();
  while (review.is_accepted()) {
    const Result result = store();
    // The operator may make room on the disk and accept again; the corrections are not lost.
    const bool may_pass = result.error_code == Result::STORAGE;
    review.answer(result.error_code == Result::SUCCESS,
                  may_pass ? "Not stored: " + result.message + " " + result.hint : result.message);
    if (!may_pass) return result;
  }
  review.answer(true, "rejected; nothing was stored");
  return with_object(outcome(LearnError::kRejectedByOperator), draft_.learned().object,
                     images_.before());
}

LessonSession::Result LessonSession::store() {
  feedback_.leave_if_interrupted();
  feedback_.tell(mbncc_vision::LearnObjectFeedback::STORE, kChecked, "Storing '" + name_ + "'.");
  return store_.store(draft_.learned(), images_.calibration());
}

}  // namespace mbncc::nodelets
