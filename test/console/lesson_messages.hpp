// SPDX-License-Identifier: BSD-3-Clause
// Messages of the learning nodelet during a lesson, and a console that receives them.
#pragma once

#include <gtest/gtest.h>
#include <mbncc_vision/LearnObjectFeedback.h>

#include "console/lesson/lesson_model.hpp"

namespace mbncc::console {

using Phase = LessonModel::Phase;
using Feedback = mbncc_vision::LearnObjectFeedback;
using Result = mbncc_vision::LearnObjectResult;

inline actionlib_msgs::GoalStatusArray status(const std::string& alive = "") {
  actionlib_msgs::GoalStatusArray array;
  if (alive.empty()) return array;
  auto& goal = array.status_list.emplace_back();
  goal.goal_id.id = alive;
  goal.status = actionlib_msgs::GoalStatus::ACTIVE;
  return array;
}

inline mbncc_vision::LearnObjectActionFeedback feedback(std::uint8_t stage, double remaining = 100,
                                                        const std::string& goal = "goal") {
  mbncc_vision::LearnObjectActionFeedback message;
  message.status.goal_id.id = goal;
  message.feedback.stage = stage;
  message.feedback.progress = 0.5f;
  message.feedback.remaining = ros::Duration(remaining);
  message.feedback.message = "Do something.";
  return message;
}

inline mbncc_vision::LearnObjectActionResult result(std::int16_t code,
                                                    const std::string& goal = "goal") {
  mbncc_vision::LearnObjectActionResult message;
  message.status.goal_id.id = goal;
  message.status.status = code == Result::SUCCESS ? actionlib_msgs::GoalStatus::SUCCEEDED
                                                  : actionlib_msgs::GoalStatus::ABORTED;
  message.result.error_code = code;
  message.result.message = "What happened.";
  message.result.hint = "What to do.";
  return message;
}

inline Result draft(std::int16_t code) {
  Result draft;
  draft.error_code = code;
  return draft;
}

inline LessonModel ready() {
  LessonModel lesson;
  lesson.take_status(status(), 0);
  return lesson;
}

inline LessonModel in_review(std::int16_t code = Result::SUCCESS) {
  LessonModel lesson = ready();
  lesson.begin("goal", 0);
  lesson.take_draft(draft(code));
  lesson.take_feedback(feedback(Feedback::WAIT_CONFIRM), 1);
  return lesson;
}

inline LessonModel::Word word(std::uint8_t command) {
  LessonModel::Word word;
  word.command = command;
  return word;
}

/// Sends a correction that is not yet answered.
inline void decide(LessonModel& lesson) {
  lesson.want(word(LessonModel::Word::EDIT));
  ASSERT_TRUE(lesson.next_word());
}

}  // namespace mbncc::console
