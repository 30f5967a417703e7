// SPDX-License-Identifier: BSD-3-Clause
// The operator's review of a lesson before it is stored: accept, reject, edit, undo.
#include <chrono>
#include <stdexcept>
#include <vector>

#include "nodelets/conversion/messages.hpp"
#include "nodelets/learning/lesson.hpp"
#include "nodelets/learning/lesson_stages.hpp"
#include "nodelets/learning/outcome.hpp"

namespace mbncc::nodelets {
namespace {

using Feedback = mbncc_vision::LearnObjectFeedback;
using Request = Confirmation::Request;
using Response = Confirmation::Response;

// Interval at which the question is repeated, for consoles that join late and to update the
// remaining time.
constexpr std::chrono::milliseconds kReminder{1000};

/// Accepts commands during the review; a call that is pending at its end is refused.
class Review {
 public:
  explicit Review(Confirmation& desk) : desk_(desk) { desk_.open(); }
  ~Review() { desk_.close(); }

 private:
  Confirmation& desk_;
};

std::string question_about(const Quality& quality) {
  std::string question = std::string("Verdict ") + to_string(quality.verdict) + ".";
  for (const auto& advice : quality.advice) question += " " + advice;
  return question + " Accept, edit or reject the outline.";
}

std::vector<LessonEdit::Line> lines_of(const std::vector<geometry_msgs::Polygon>& strokes) {
  std::vector<LessonEdit::Line> lines;
  for (const auto& stroke : strokes) {
    const auto line = from_msg(stroke);
    if (!line) throw std::invalid_argument("a point of a stroke is not finite; draw it again");
    lines.push_back(*line);
  }
  return lines;
}

/// Throws std::invalid_argument with a sentence.
LessonEdit edit_of(const Request& request, cv::Size size, bool further_view) {
  LessonEdit edit;
  edit.include = lines_of(request.include);
  edit.exclude = lines_of(request.exclude);
  edit.stroke_width = request.stroke_width;
  const auto region = from_msg(request.roi, size);
  if (!region) throw std::invalid_argument("the new roi does not lie in the image; draw it inside");
  edit.region = *region;
  if (request.set_reference) {
    edit.reference = from_msg(request.reference);
    if (!edit.reference)
      throw std::invalid_argument(
          "the new reference must be finite and within 32768 px; give x, y [px] and theta [rad]");
  }
  if (edit.reference && further_view)
    throw std::invalid_argument(
        "a further view takes the frame of the stored object; move it with edit_object");
  if (edit.include.empty() && edit.exclude.empty() && edit.region.empty() && !edit.reference)
    throw std::invalid_argument("nothing to edit; give strokes, a new roi or a new reference");
  return edit;
}

}  // namespace

LessonRun::Result LessonRun::review() {
  const Review review(tools_.confirmation);
  client_.wait_for_operator();
  for (;;) {
    const Request command = ask_operator();
    Response response;
    if (command.command == Request::ACCEPT && may_be_stored()) {
      const Result result = store();
      response.success = result.error_code == Result::SUCCESS;
      response.message = result.message;
      response.quality = to_msg(learned_.object.quality);
      tools_.confirmation.answer(response);
      return result;
    }
    carry_out(command, response);
    response.quality = to_msg(learned_.object.quality);
    tools_.confirmation.answer(response);
    if (command.command == Request::REJECT)
      return describe(outcome(LearnError::kRejectedByOperator), learned_.object);
  }
}

Request LessonRun::ask_operator() {
  for (;;) {
    tell(Feedback::WAIT_CONFIRM, kLearned, question_about(learned_.object.quality), true);
    const auto command =
        tools_.confirmation.next([this] { return client_.interruption().has_value(); }, kReminder);
    leave_if_interrupted();
    if (command) return *command;
  }
}

void LessonRun::carry_out(const Request& command, Response& response) {
  switch (command.command) {
    case Request::ACCEPT:
      response.success = false;
      response.message = "the verdict is BAD; edit or reject, or teach with allow_bad";
      return;
    case Request::REJECT:
      response.success = true;
      response.message = "rejected; nothing was stored";
      return;
    case Request::EDIT:
      return edit(command, response);
    case Request::UNDO:
      return undo(response);
    default:
      response.success = false;
      response.message = "command " + std::to_string(command.command) + " does not exist";
  }
}

void LessonRun::edit(const Confirmation::Request& command, Response& response) {
  response.success = false;
  try {
    const LessonEdit edit = edit_of(command, before_.image.size(), goal_.add_view);
    const LearnResult edited = draft_->edit(edit, observer());
    response.message = edited.message;
    response.success = edited.has_model;
  } catch (const std::invalid_argument& fault) {
    response.message = fault.what();
  }
  take_draft();
}

void LessonRun::undo(Response& response) {
  response.success = draft_->undo();
  response.message = response.success ? "the last edit is undone" : "there is no edit to undo";
  take_draft();
}

}  // namespace mbncc::nodelets
