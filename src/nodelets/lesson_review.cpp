// The operator's check of a lesson before it is stored: accept, reject, edit, undo.
#include <utility>

#include "nodelets/lesson.hpp"
#include "nodelets/lesson_stages.hpp"
#include "nodelets/messages.hpp"
#include "nodelets/outcome.hpp"

namespace mbncc::nodelets {
namespace {

using Feedback = mbncc_vision::LearnObjectFeedback;
using Request = Confirmation::Request;
using Response = Confirmation::Response;

/// Takes commands as long as the review lasts; whoever still asks when it ends is told so.
class Review {
 public:
  explicit Review(Confirmation& desk) : desk_(desk) { desk_.open(); }
  ~Review() { desk_.close(); }

 private:
  Confirmation& desk_;
};

std::string fault_of(const Request& edit, const Lesson& lesson) {
  if (!edit.include.empty() || !edit.exclude.empty())
    return "strokes are not available yet; give a new roi or reference, or REJECT";
  if (edit.roi.width == 0 && edit.roi.height == 0 && !edit.set_reference)
    return "nothing to edit; give a new roi or reference";
  if (!from_msg(edit.roi, lesson.before.size())) return "the new roi does not lie in the picture";
  if (edit.set_reference && !from_msg(edit.reference)) return "the new reference is not finite";
  return "";
}

std::string question_about(const Quality& quality) {
  std::string question = std::string("Verdict ") + to_string(quality.verdict) + ".";
  for (const auto& advice : quality.advice) question += " " + advice;
  return question + " Accept, edit or reject the outline.";
}

}  // namespace

LessonRun::Result LessonRun::review() {
  const Review review(tools_.confirmation);
  for (;;) {
    tell(Feedback::WAIT_CONFIRM, kLearned, question_about(draft_.learned.object.quality), true);
    const auto command =
        tools_.confirmation.next([this] { return client_.interruption().has_value(); });
    leave_if_interrupted();
    Response response;
    if (command->command == Request::ACCEPT && may_be_stored()) {
      const Result result = store();
      response.success = result.error_code == Result::SUCCESS;
      response.message = result.message;
      response.quality = to_msg(draft_.learned.object.quality);
      tools_.confirmation.answer(response);
      return result;
    }
    carry_out(*command, response);
    response.quality = to_msg(draft_.learned.object.quality);
    tools_.confirmation.answer(response);
    if (command->command == Request::REJECT)
      return describe(outcome(LearnError::kRejectedByOperator), draft_.learned.object);
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

void LessonRun::edit(const Request& command, Response& response) {
  response.success = false;
  response.message = fault_of(command, draft_.lesson);
  if (!response.message.empty()) return;
  Lesson lesson = draft_.lesson;
  const cv::Rect region = *from_msg(command.roi, lesson.before.size());
  if (!region.empty()) lesson.region = region;
  if (command.set_reference) lesson.reference = from_msg(command.reference);
  Draft edited = learn(lesson);
  response.message = edited.learned.message;
  if (!edited.learned.has_model) return;
  earlier_.push_back(std::exchange(draft_, std::move(edited)));
  response.success = true;
}

void LessonRun::undo(Response& response) {
  response.success = !earlier_.empty();
  response.message = response.success ? "the last edit is taken back" : "there is no edit to undo";
  if (!response.success) return;
  draft_ = std::move(earlier_.back());
  earlier_.pop_back();
  tools_.show_preview(preview(draft_.learned.object));
}

}  // namespace mbncc::nodelets
