// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/lesson_feedback.hpp"

#include "nodelets/conversion/messages.hpp"
#include "nodelets/learning/outcome.hpp"

namespace mbncc::nodelets {

void end_lesson(const mbncc_vision::LearnObjectResult& result) {
  throw LessonEnded{result};
}

void end_lesson(LearnError error, const std::string& message, const std::string& hint) {
  end_lesson(outcome(error, message, hint));
}

LessonFeedback::LessonFeedback(LessonClient& client) : client_(client) {
  set_place({});
}

void LessonFeedback::tell(std::uint8_t stage, double progress, const std::string& message) {
  send(stage, progress, message, false);
}

void LessonFeedback::ask(std::uint8_t stage, double progress, const std::string& request) {
  last_request_ = request;
  send(stage, progress, request, true);
}

void LessonFeedback::set_place(const std::optional<cv::Rect>& place) {
  place_ = place ? to_msg(*place) : client_.goal().roi;
}

void LessonFeedback::leave_if_interrupted() const {
  if (const auto why = interruption()) end_lesson(*why);
}

void LessonFeedback::send(std::uint8_t stage, double progress, const std::string& message,
                          bool operator_action) {
  mbncc_vision::LearnObjectFeedback feedback;
  feedback.stage = stage;
  feedback.progress = static_cast<float>(progress);
  feedback.message = message;
  feedback.operator_action = operator_action;
  feedback.roi = place_;
  client_.tell(feedback);
}

}  // namespace mbncc::nodelets
