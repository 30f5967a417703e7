// SPDX-License-Identifier: BSD-3-Clause
#include "console/lesson/lesson_model.hpp"

#include <mbncc_vision/LearnObjectFeedback.h>

#include <algorithm>
#include <utility>

namespace mbncc::console {
namespace {

using actionlib_msgs::GoalStatus;
using Feedback = mbncc_vision::LearnObjectFeedback;
using Result = mbncc_vision::LearnObjectResult;

bool is_alive(const GoalStatus& goal) {
  switch (goal.status) {
    case GoalStatus::PENDING:
    case GoalStatus::ACTIVE:
    case GoalStatus::PREEMPTING:
    case GoalStatus::RECALLING:
      return true;
    default:
      return false;
  }
}

Level level_of_end(const Result& result) {
  if (result.error_code == Result::SUCCESS) return level_of_verdict(result.object.quality.verdict);
  const bool wanted =
      result.error_code == Result::REJECTED_BY_OPERATOR || result.error_code == Result::CANCELLED;
  return wanted ? Level::kUnknown : Level::kBad;
}

}  // namespace

Result outcome_of(const mbncc_vision::LearnObjectActionResult& result) {
  Result outcome = result.result;
  if (outcome.error_code != Result::SUCCESS ||
      result.status.status == actionlib_msgs::GoalStatus::SUCCEEDED)
    return outcome;
  outcome.error_code = Result::CANCELLED;
  outcome.message = "The lesson was cancelled before it began.";
  outcome.hint = "Teach again; if this recurs, compare the machines' clocks.";
  return outcome;
}

bool LessonModel::under_way() const {
  return phase_ == Phase::kRunning || phase_ == Phase::kReview || phase_ == Phase::kDeciding;
}

void LessonModel::take_status(const actionlib_msgs::GoalStatusArray& status, double now) {
  heard_ = now;
  if (phase_ == Phase::kNoServer) get_ready();
  const auto& goals = status.status_list;
  const auto alive = std::find_if(goals.begin(), goals.end(), is_alive);
  const bool goes_on = std::any_of(goals.begin(), goals.end(), [&](const GoalStatus& goal) {
    return is_alive(goal) && goal.goal_id.id == goal_;
  });
  if (under_way()) {
    if (goes_on)
      goal_seen_ = now;
    else if (now - goal_seen_ > kSilence)
      end("The lesson was lost", "The learning nodelet was restarted. Press Teach again.",
          Level::kBad);
  } else if (alive != goals.end()) {
    // The lesson was started by another client, or by this window before it was closed.
    join(alive->goal_id.id, now);
    detail_ = "A lesson is running.";
  }
}

void LessonModel::take_feedback(const mbncc_vision::LearnObjectActionFeedback& feedback,
                                double now) {
  heard_ = now;
  if (!under_way()) join(feedback.status.goal_id.id, now);
  if (feedback.status.goal_id.id != goal_) return;
  goal_seen_ = now;
  stage_ = feedback.feedback.stage;
  const double remaining = feedback.feedback.remaining.toSec();
  deadline_ = remaining > 0 ? now + remaining : -1;
  const bool asked = stage_ == Feedback::WAIT_CONFIRM;
  const bool again = asked && (phase_ == Phase::kReview || phase_ == Phase::kDeciding) &&
                     feedback.feedback.message == question_;
  if (again) return;
  question_ = asked ? feedback.feedback.message : "";
  // A draft received before the first feedback belongs to an earlier lesson, unless this lesson was
  // joined in review.
  if (std::exchange(unheard_, false) && !asked) {
    newest_draft_.reset();
    corrections_ = 0;
  }
  progress_ = feedback.feedback.progress;
  detail_ = feedback.feedback.message;
  level_ = Level::kUnknown;
  phase_ = asked ? Phase::kReview : Phase::kRunning;
  if (asked && !refusal_.empty()) {
    detail_ = std::exchange(refusal_, "");
    level_ = Level::kBad;
  }
  if (asked && !draft_) show_draft(newest_draft_);
}

void LessonModel::take_draft(const Result& draft) {
  newest_draft_ = draft;
  acceptable_ = draft.error_code == Result::SUCCESS;
  insisted_ = false;
  // After a correction, the lesson passes through its stages again before it asks the operator
  // again.
  if (draft_ || phase_ == Phase::kReview) show_draft(newest_draft_);
}

void LessonModel::take_result(const mbncc_vision::LearnObjectActionResult& result, double now) {
  heard_ = now;
  if (under_way() && result.status.goal_id.id != goal_) return;
  const Result outcome = outcome_of(result);
  const bool stored = outcome.error_code == Result::SUCCESS;
  end(stored ? "Learned" : "Nothing was stored",
      stored || outcome.hint.empty() ? outcome.message : outcome.message + " " + outcome.hint,
      level_of_end(outcome));
  if (stored) learned_ = Learned{outcome.object.name, outcome.object.revision};
}

bool LessonModel::take_library(const std::vector<mbncc_vision::LearnedObject>& objects) {
  if (phase_ != Phase::kReady || !learned_) return false;
  const bool listed = std::any_of(objects.begin(), objects.end(), [&](const auto& object) {
    return object.name == learned_->name && object.revision == learned_->revision;
  });
  // The list may have been sent before the result.
  learned_->listed |= listed;
  if (listed || !learned_->listed) return false;
  get_ready();
  return true;
}

void LessonModel::begin(const std::string& goal, double now) {
  newest_draft_.reset();  // it belongs to another lesson
  join(goal, now);
  own_ = true;
  corrections_ = 0;
}

void LessonModel::join(const std::string& goal, double now) {
  phase_ = Phase::kRunning;
  question_.clear();
  refusal_.clear();
  goal_ = goal;
  own_ = false;
  stage_ = Feedback::WAIT_IMAGE;
  progress_ = 0;
  deadline_ = -1;
  goal_seen_ = now;
  unheard_ = true;
  learned_.reset();
  corrections_ = -1;
  words_.clear();
  asked_.reset();
  detail_ = "Requesting a lesson.";
  level_ = Level::kUnknown;
  show_draft({});
}

void LessonModel::show_draft(const std::optional<Result>& draft) {
  draft_ = draft;
  ++draft_number_;
}

void LessonModel::want(const Word& word) {
  if (!may_correct()) return;
  const bool correction = word.command == Word::EDIT || word.command == Word::UNDO;
  // Accept and Reject refer to the draft that is shown, so they are sent at once.
  if (correction || phase_ == Phase::kReview) words_.push_back(word);
}

std::optional<LessonModel::Word> LessonModel::next_word() {
  if (phase_ != Phase::kReview || words_.empty() || asked_) return {};
  asked_ = words_.front();
  asked_->goal_id = goal_;
  words_.pop_front();
  phase_ = Phase::kDeciding;
  detail_ = "Working on it.";
  return asked_;
}

std::deque<LessonModel::Word> LessonModel::waiting() const {
  std::deque<Word> drawn = words_;
  if (asked_) drawn.push_front(*asked_);
  return drawn;
}

bool LessonModel::may_undo() const {
  if (!may_correct()) return false;
  if (corrections_ < 0) return true;
  int expected = corrections_;
  for (const auto& word : waiting()) {
    if (word.command == Word::EDIT) ++expected;
    if (word.command == Word::UNDO) expected = std::max(0, expected - 1);
  }
  return expected > 0;
}

void LessonModel::take_answer(bool success, const std::string& message) {
  if (!under_way()) return;
  count_corrections(success);
  go_on(success, message);
}

void LessonModel::take_no_answer(const std::string& message) {
  if (!under_way()) return;
  corrections_ = -1;
  go_on(false, message);
}

void LessonModel::go_on(bool success, const std::string& message) {
  asked_.reset();
  // The lesson has passed through further stages since, and is about to ask again.
  if (phase_ == Phase::kRunning && !success) refusal_ = message;
  if (phase_ != Phase::kDeciding && phase_ != Phase::kReview) return;
  phase_ = Phase::kReview;
  level_ = success ? Level::kUnknown : Level::kBad;
  if (!success) detail_ = message;
}

void LessonModel::count_corrections(bool success) {
  if (!asked_) return;
  if (asked_->command == Word::EDIT && success && corrections_ >= 0) ++corrections_;
  if (asked_->command == Word::EDIT && !success) withdraw_undo_of_refused();
  if (asked_->command != Word::UNDO) return;
  // A refused undo means that there is nothing to undo.
  if (!success) corrections_ = 0;
  if (success && corrections_ > 0) --corrections_;
}

/// Removes the undo that was meant for the refused correction; it would undo an earlier one.
void LessonModel::withdraw_undo_of_refused() {
  int later = 0;
  for (auto word = words_.begin(); word != words_.end(); ++word) {
    if (word->command == Word::EDIT) ++later;
    if (word->command != Word::UNDO || later-- > 0) continue;
    words_.erase(word);
    return;
  }
}

void LessonModel::look_at_clock(double now) {
  if (phase_ == Phase::kNoServer || now - heard_ <= kSilence) return;
  const bool lost = under_way();
  end("The learning nodelet has stopped",
      lost ? "The lesson is lost. This window continues automatically when the nodelet is back."
           : "This window continues automatically when the nodelet is back.",
      Level::kBad);
  phase_ = Phase::kNoServer;
}

bool LessonModel::waits_for_scene() const {
  return phase_ == Phase::kRunning &&
         (stage_ == Feedback::WAIT_REMOVAL || stage_ == Feedback::WAIT_STILL);
}

std::string LessonModel::headline() const {
  if (!camera_alive_ && (phase_ == Phase::kReady || stage_ == Feedback::WAIT_IMAGE) &&
      phase_ != Phase::kNoServer)
    return "No image from the camera";
  return under_way() ? headline_of(stage_) : headline_;
}

std::string LessonModel::detail() const {
  // The advice is shown beside the image, so it is not repeated here.
  if (phase_ == Phase::kReview && draft_ && detail_ == question_)
    return "Verdict " + word_of_verdict(draft_->object.quality.verdict) +
           (may_accept() ? ". Accept, correct or reject the outline."
                         : ". Correct or reject the outline, or tick that you have checked it.");
  if (!camera_alive_ && phase_ == Phase::kReady)
    return detail_ + " No image arrives: check the camera's cable and driver before you teach.";
  return detail_;
}

std::string LessonModel::time_left(double now) const {
  return under_way() && deadline_ >= 0 ? console::time_left(std::max(0.0, deadline_ - now)) : "";
}

void LessonModel::get_ready() {
  end("Ready", "Put the object on the platform, keep still, press Teach.", Level::kGood);
}

void LessonModel::end(const std::string& headline, const std::string& detail, Level level) {
  phase_ = Phase::kReady;
  headline_ = headline;
  detail_ = detail;
  level_ = level;
  progress_ = 0;
  deadline_ = -1;
  show_draft({});
  insisted_ = false;
  words_.clear();
  asked_.reset();
  learned_.reset();
}

}  // namespace mbncc::console
