// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/lesson_draft.hpp"

#include <mbncc_vision/LearnObjectFeedback.h>

#include <opencv2/imgproc.hpp>
#include <utility>

#include "mbncc/cell/part_put_down.hpp"
#include "mbncc/learning/further_view.hpp"
#include "mbncc/learning/resemblance.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/conversion/messages.hpp"
#include "nodelets/learning/lesson_goal.hpp"
#include "nodelets/learning/outcome.hpp"

namespace mbncc::nodelets {
namespace {

using Feedback = mbncc_vision::LearnObjectFeedback;
using Goal = mbncc_vision::LearnObjectGoal;

std::uint8_t feedback_stage(Stage stage) {
  if (stage == Stage::kRegion) return Feedback::REGION;
  return stage == Stage::kSegment ? Feedback::SEGMENT : Feedback::QUALITY;
}

/// Box around the map in the learning image. [px]
cv::Rect place_of(const View& view) {
  return cv::boundingRect(view.map) + view.origin;
}

}  // namespace

GoalLesson to_lesson(const Goal& goal, const std::string& name, const cv::Mat& before,
                     const cv::Mat& after) {
  GoalLesson made{described(goal, name), {}};
  Lesson& lesson = made.lesson;
  lesson.before = before;
  if (goal.mode == Goal::CHANGE || goal.mode == Goal::ROI) {
    const auto region = from_msg(goal.roi, before.size());
    if (!region) made.fault = outcome(LearnError::kRegionInvalid);
    lesson.region = region.value_or(cv::Rect{});
  }
  if (goal.mode == Goal::CHANGE) lesson.after = after;
  if (goal.mode == Goal::OUTLINE) lesson.outline = *from_msg(goal.outline);
  if (goal.mode == Goal::CLICK)
    lesson.click = cv::Point2f(static_cast<float>(goal.point.x), static_cast<float>(goal.point.y));
  if (goal.mode == Goal::MASK) {
    const Decoded mask = decode_map(goal.mask);
    if (!mask)
      made.fault = outcome(LearnError::kEncoding, "Mask: " + mask.fault + ".",
                           "Send mono8 of the image's size, with 255 on the object.");
    lesson.map = mask.image;
  }
  const bool mismatch = (!lesson.after.empty() && lesson.after.size() != before.size()) ||
                        (!lesson.map.empty() && lesson.map.size() != before.size());
  if (mismatch) made.fault = outcome(LearnError::kImageMismatch);
  return made;
}

LessonDraft::LessonDraft(const Goal& goal, std::string name, const LessonTools& tools,
                         const LessonImages& images, LessonFeedback& feedback)
    : goal_(goal), name_(std::move(name)), tools_(tools), images_(images), feedback_(feedback) {}

Lesson LessonDraft::lesson() const {
  GoalLesson made = to_lesson(goal_, name_, images_.before().image, images_.after().image);
  if (made.fault) end_lesson(*made.fault);
  return made.lesson;
}

void LessonDraft::learn() {
  interactive_.emplace(lesson(), tools_.config, tools_.search, observer());
  tools_.display.show_image(images_.before().image);
  update();
}

LearnResult LessonDraft::edit(const LessonEdit& edit) {
  LearnResult edited = interactive_->edit(edit, observer());
  update();
  return edited;
}

bool LessonDraft::undo() {
  const bool undone = interactive_->undo();
  update();
  return undone;
}

bool LessonDraft::overlaps_old_place() const {
  if (!learned_.has_model || goal_.mode != Goal::CHANGE) return false;
  // By colours alone, one right lesson in ten would be refused.
  if (learned_.evidence && learned_.evidence->edges_after < kMostEdgesAfter) return false;
  const cv::Mat map = full_size_map(learned_.object.views.front());
  return part_put_down(map, images_.before().image, images_.after().image) >= kMostPutDown;
}

bool LessonDraft::may_be_stored() const {
  return !view_refused_ &&
         (learned_.error == LearnError::kSuccess || (learned_.has_model && goal_.allow_bad));
}

StageObserver LessonDraft::observer() {
  return [this](Stage stage, double progress, const std::string& message, const cv::Mat& image) {
    feedback_.tell(feedback_stage(stage), kTaken + (kLearned - kTaken) * progress, message);
    if (!image.empty()) tools_.display.show_stage(image);
    return !feedback_.interruption();
  };
}

void LessonDraft::update() {
  feedback_.leave_if_interrupted();
  learned_ = interactive_->result();
  view_refused_ = false;
  feedback_.set_place({});
  if (!learned_.has_model) return;
  feedback_.set_place(place_of(learned_.object.views.front()));
  note_resemblance(learned_.object, images_.before().image, tools_.library.snapshot()->objects,
                   tools_.search);
  if (goal_.add_view) try_further_view();
  feedback_.leave_if_interrupted();
  tools_.display.show_preview(preview_of(learned_.object, images_.before().image));
  tools_.display.show_draft(outcome(learned_, images_.before()));
  tools_.display.show_score_map(learned_.object, images_.before().image, tools_.search);
}

void LessonDraft::try_further_view() {
  const auto stored = tools_.library.snapshot()->find(name_);
  if (!stored) return;
  const auto refusal = try_view(learned_.object, *stored, images_.before().image, tools_.search);
  if (!refusal) return;
  view_refused_ = true;
  learned_.error = refusal->error;
  learned_.message = refusal->message;
  learned_.hint = refusal->hint;
}

}  // namespace mbncc::nodelets
