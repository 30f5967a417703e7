// SPDX-License-Identifier: BSD-3-Clause
#include "console/lesson/lesson_controller.hpp"

#include <algorithm>

#include "console/image/image_view.hpp"
#include "console/image/scaled_image.hpp"
#include "console/lesson/lesson_bar.hpp"
#include "console/lesson/review_pane.hpp"
#include "console/library/library_controller.hpp"
#include "console/library/library_strip.hpp"
#include "console/library/object_name.hpp"

namespace mbncc::console {
namespace {

using Result = mbncc_vision::LearnObjectResult;
using What = TeachingWish::What;

constexpr const char* kCaption = "Still image: before the object left";

// The same length as in the lesson's preview.
double axes_length(const QSize& image) {
  return std::max(30.0, image.width() / 16.0);
}

}  // namespace

LessonController::LessonController(const SteadyClock& clock, RosLink& ros, const Widgets& widgets,
                                   LibraryController& library, QObject* parent)
    : QObject(parent), clock_(clock), ros_(ros), widgets_(widgets), library_(library) {
  connect_server();
  connect_operator();
}

void LessonController::connect_server() {
  connect(&ros_, &RosLink::status_heard, this, [this](const auto& status) {
    const bool was_gone = lesson_.phase() == LessonModel::Phase::kNoServer;
    lesson_.take_status(status, clock_.now());
    if (was_gone) Q_EMIT server_came();
    show();
  });
  connect(&ros_, &RosLink::feedback_heard, this, [this](const auto& feedback) {
    lesson_.take_feedback(feedback, clock_.now());
    send_next();
    show();
  });
  connect(&ros_, &RosLink::lesson_image_heard, this,
          [this](const QImage& image) { image_ = image; });
  connect(&ros_, &RosLink::draft_heard, this, [this](const auto& draft) {
    lesson_.take_draft(draft);
    show();
  });
  connect(&ros_, &RosLink::result_heard, this, &LessonController::end_lesson);
  connect(&ros_, &RosLink::confirmed, this,
          [this](bool answered, bool success, const QString& message) {
            if (answered)
              lesson_.take_answer(success, message.toStdString());
            else
              lesson_.take_no_answer(message.toStdString());
            send_next();
            show();
          });
  connect(&ros_, &RosLink::score_map_heard, &widgets_.review, &ReviewPane::show_score_map);
  connect(&ros_, &RosLink::objects_listed, this, [this](const auto& objects, const auto&) {
    if (lesson_.take_library(objects)) withdraw_question();
    show();
  });
}

void LessonController::connect_operator() {
  connect(&widgets_.bar, &LessonBar::teach_wanted, this, &LessonController::want_lesson);
  connect(&widgets_.bar, &LessonBar::cancel_wanted, this, [this] { ros_.cancel(lesson_.goal()); });
  connect(&widgets_.bar, &LessonBar::name_edited, this, &LessonController::withdraw_question);
  connect(&widgets_.image, &ImageView::corrected, this, &LessonController::send);
  connect(&widgets_.review, &ReviewPane::decided, this, &LessonController::send_word);
  connect(&widgets_.review, &ReviewPane::insisted, this, [this](bool insisted) {
    lesson_.insist(insisted);
    show();
  });
  connect(&widgets_.review, &ReviewPane::tool_chosen, this, [this](int tool) {
    widgets_.image.tool().choose(static_cast<Tool>(tool));
    widgets_.image.update();
  });
  connect(&widgets_.review, &ReviewPane::stroke_width_chosen, this,
          [this](int width) { widgets_.image.tool().set_stroke_width(width); });
  connect(&library_, &LibraryController::name_gone, this, &LessonController::withdraw_question);
  connect(&widgets_.strip, &LibraryStrip::view_wanted, this, [this](const QString& name) {
    begin({What::kView, name.toStdString()});
  });
}

void LessonController::want_lesson() {
  if (!lesson_.may_teach()) return;
  const std::string name = widgets_.bar.goal().name;
  if (library_.library().find(name) != nullptr) return ask_about_name(name);
  begin({What::kNew, name});
}

void LessonController::ask_about_name(const std::string& name) {
  widgets_.bar.clear_notice();
  const std::string other = free_name(name, library_.library().names());
  const auto* known = library_.library().find(name);
  widgets_.bar.ask(
      "The name is taken",
      {Level::kUnknown, "'" + name +
                            "' is in the library already. Replace it, add a view to "
                            "it, or teach this one under the new name '" +
                            other + "'?" + (known != nullptr ? loss_of(*known) : "")},
      {{"Re&place it",
        "Teach it again, with its height and symmetry if none are given; Undo edit restores the "
        "old one",
        [this, name] {
          begin({What::kReplace, name});
        }},
       {"&Add view", "Teach this side also in different light or slightly rotated",
        [this, name] {
          begin({What::kView, name});
        }},
       {"Ne&w name", "Teach it as another object, '" + QString::fromStdString(other) + "'",
        [this, other] {
          widgets_.bar.set_name(other);
          begin({What::kNew, other});
        }}});
  widgets_.bar.give_keyboard_to_answers();
}

void LessonController::begin(const TeachingWish& wish) {
  if (!lesson_.may_teach()) return;
  wish_ = wish;
  viewed_ = wish.what == What::kView ? wish.name : "";
  widgets_.bar.clear_notice();
  widgets_.bar.withdraw_question();
  library_.begin_lesson(wish.name);
  const auto goal = goal_of(wish, widgets_.bar.goal(), library_.library().find(wish.name));
  if (wish.what == What::kReplace) widgets_.bar.show_goal(goal);
  lesson_.begin(ros_.teach(goal), clock_.now());
  widgets_.image.setFocus();
  show();
}

void LessonController::end_lesson(const mbncc_vision::LearnObjectActionResult& result) {
  const bool own = lesson_.is_own(result.status.goal_id.id);
  lesson_.take_result(result, clock_.now());
  show();
  if (!own) return;
  const Result outcome = outcome_of(result);
  // The server may have chosen the name that another lesson took meanwhile.
  if (outcome.error_code == Result::NAME_TAKEN)
    return ask_about_name(wish_.name.empty() ? outcome.object.name : wish_.name);
  if (outcome.error_code == Result::SUCCESS) {
    library_.retaught(outcome.object.name);
    widgets_.strip.choose(QString::fromStdString(outcome.object.name));
    widgets_.bar.clear_object();
    return offer_next_view(outcome.object.name);
  }
  if (!viewed_.empty()) offer_next_view(viewed_);
}

/// Space starts the next view only while views of an object are being taught.
void LessonController::offer_next_view(const std::string& name) {
  const bool goes_on = !viewed_.empty();
  const std::string question =
      goes_on ? " Rotate '" + name + "' slightly or change the light, then press Space."
              : " Should it also be found in different light?";
  widgets_.bar.ask(
      "", {lesson_.level(), lesson_.detail() + question},
      {{goes_on ? "Ne&xt view (Space)" : "Teach anothe&r view",
        "Lay the object down in another position before you press this",
        [this, name] {
          begin({What::kView, name});
        }},
       {goes_on ? "Done" : "No", "Finish teaching views (Esc)", [this] { viewed_.clear(); }}});
}

void LessonController::withdraw_question() {
  viewed_.clear();
  widgets_.bar.withdraw_question();
}

void LessonController::next_view() {
  if (!viewed_.empty()) begin({What::kView, viewed_});
}

void LessonController::choose_tool(Tool tool) {
  if (!lesson_.draft()) return;
  widgets_.review.choose_tool(tool);
  widgets_.image.setFocus();
}

void LessonController::send(const Confirm& request) {
  widgets_.bar.clear_notice();
  lesson_.want(request);
  send_next();
  show();
}

void LessonController::send_word(int command) {
  if (command == Confirm::ACCEPT && !lesson_.may_accept()) return;
  if (command == Confirm::UNDO && !lesson_.may_undo()) return;
  // Move the focus first: the button is about to be disabled, and Qt would pass the focus to the
  // next widget.
  if (command != Confirm::UNDO) widgets_.image.setFocus();
  Confirm request;
  request.command = static_cast<std::uint8_t>(command);
  send(request);
}

void LessonController::send_next() {
  if (const auto word = lesson_.next_word()) ros_.confirm(*word);
}

void LessonController::look_at_clock(bool camera) {
  const auto before = lesson_.phase();
  lesson_.look_at_clock(clock_.now());
  lesson_.take_camera(camera);
  if (lesson_.phase() == LessonModel::Phase::kNoServer && lesson_.phase() != before) {
    // A call that waits for a hung server must not delay calls to its successor.
    ros_.give_up_teaching();
    widgets_.bar.withdraw_question();
    Q_EMIT server_gone();
  }
  show();
}

void LessonController::show() {
  widgets_.bar.show_lesson(lesson_, clock_.now());
  widgets_.review.show_lesson(lesson_);
  widgets_.image.show_waiting(lesson_.waiting());
  ros_.show_changes(lesson_.waits_for_scene());
  Q_EMIT changed();
  if (lesson_.draft_number() == draft_shown_) return;
  draft_shown_ = lesson_.draft_number();
  Q_EMIT draft_changed();
  if (lesson_.draft()) show_draft();
}

void LessonController::show_draft() {
  const auto& draft = *lesson_.draft();
  const QImage preview = to_qimage(to_rgb(draft.preview));
  widgets_.image.tool().set_axes(draft.object.reference, axes_length(preview.size()));
  if (image_.size() == preview.size())
    widgets_.image.show_image(image_, preview.size(), marks_of(draft), kCaption);
  else
    widgets_.image.show_image(preview, preview.size(), {}, kCaption);
}

}  // namespace mbncc::console
