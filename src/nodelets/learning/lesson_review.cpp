// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/lesson_review.hpp"

#include <mbncc_vision/LearnObjectFeedback.h>

#include <chrono>
#include <stdexcept>
#include <vector>

#include "nodelets/conversion/messages.hpp"

namespace mbncc::nodelets {
namespace {

using Feedback = mbncc_vision::LearnObjectFeedback;
using Request = Confirmation::Request;
using Response = Confirmation::Response;

// Interval at which the question is repeated, for consoles that join late and to update the
// remaining time.
constexpr std::chrono::milliseconds kReminder{1000};

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

/// Converts a request. Throws std::invalid_argument with a message if it is invalid.
LessonEdit edit_of(const Request& request, cv::Size size, bool further_view) {
  LessonEdit edit;
  edit.include = lines_of(request.include);
  edit.exclude = lines_of(request.exclude);
  edit.stroke_width = request.stroke_width;
  const auto region = from_msg(request.roi, size);
  if (!region) throw std::invalid_argument("the new roi is not inside the image; draw it inside");
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

LessonReview::LessonReview(Confirmation& confirmation, const std::string& goal_id,
                           LessonDraft& draft, LessonFeedback& feedback, cv::Size image,
                           bool further_view)
    : confirmation_(confirmation),
      draft_(draft),
      feedback_(feedback),
      image_(image),
      further_view_(further_view) {
  confirmation_.open(goal_id);
}

LessonReview::~LessonReview() {
  confirmation_.close();
}

bool LessonReview::is_accepted() {
  for (;;) {
    const Request command = next_command();
    if (command.command == Request::ACCEPT && draft_.may_be_stored()) return true;
    if (command.command == Request::REJECT) return false;
    carry_out(command);
  }
}

void LessonReview::answer(bool success, const std::string& message) {
  Response response;
  response.success = success;
  response.message = message;
  response.quality = to_msg(draft_.learned().object.quality);
  confirmation_.answer(response);
}

Request LessonReview::next_command() {
  for (;;) {
    feedback_.ask(Feedback::WAIT_CONFIRM, kLearned,
                  question_about(draft_.learned().object.quality));
    const auto command =
        confirmation_.next([this] { return feedback_.interruption().has_value(); }, kReminder);
    feedback_.leave_if_interrupted();
    if (command) return *command;
  }
}

void LessonReview::carry_out(const Request& command) {
  switch (command.command) {
    case Request::ACCEPT:
      return answer(false, draft_.is_view_refused()
                               ? draft_.learned().message + " " + draft_.learned().hint
                               : "the verdict is BAD; edit or reject, or teach with allow_bad");
    case Request::EDIT:
      return edit(command);
    case Request::UNDO: {
      const bool undone = draft_.undo();
      return answer(undone, undone ? "the last edit is undone" : "there is no edit to undo");
    }
    default:
      return answer(false, "command " + std::to_string(command.command) + " does not exist");
  }
}

void LessonReview::edit(const Request& command) {
  try {
    const LearnResult edited = draft_.edit(edit_of(command, image_, further_view_));
    answer(edited.has_model, edited.message);
  } catch (const std::invalid_argument& fault) {
    answer(false, fault.what());
  }
}

}  // namespace mbncc::nodelets
