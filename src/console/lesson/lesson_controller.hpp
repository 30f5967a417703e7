// SPDX-License-Identifier: BSD-3-Clause
// Carries out the operator's actions in a lesson: begins it, sends corrections and decisions, and
// asks about names that are taken and about further views.
#pragma once

#ifndef Q_MOC_RUN
#include "console/image/marking_tool.hpp"
#include "console/lesson/lesson_model.hpp"
#include "console/lesson/teaching_wish.hpp"
#include "console/ros_link.hpp"
#include "console/steady_clock.hpp"
#endif

#include <QImage>
#include <QObject>
#include <string>

namespace mbncc::console {

class ImageView;
class LessonBar;
class LibraryController;
class LibraryStrip;
class ReviewPane;

class LessonController : public QObject {
  Q_OBJECT

 public:
  /// The widgets that it serves.
  struct Widgets {
    LessonBar& bar;
    ReviewPane& review;
    ImageView& image;
    LibraryStrip& strip;
  };

  /// All arguments must exist while it receives signals.
  LessonController(const SteadyClock& clock, RosLink& ros, const Widgets& widgets,
                   LibraryController& library, QObject* parent);

  const LessonModel& lesson() const { return lesson_; }
  /// Whether Space starts the next view of an object.
  bool offers_view() const { return !viewed_.empty() && lesson_.may_teach(); }

  void next_view();
  /// Sends `command` of ConfirmLearning: ACCEPT, REJECT or UNDO.
  void send_word(int command);
  void choose_tool(Tool tool);
  void withdraw_question();
  /// Call this several times per second. `camera`: whether the camera sends images.
  void look_at_clock(bool camera);

 Q_SIGNALS:
  /// The lesson may have changed, and its widgets show it.
  void changed();
  /// A draft to review has appeared, changed or disappeared.
  void draft_changed();
  /// The learning nodelet is running again, perhaps with other objects in its library.
  void server_came();
  void server_gone();

 private:
  using Confirm = mbncc_vision::ConfirmLearning::Request;

  void connect_server();
  void connect_operator();
  void want_lesson();
  void ask_about_name(const std::string& name);
  void begin(const TeachingWish& wish);
  void end_lesson(const mbncc_vision::LearnObjectActionResult& result);
  void offer_next_view(const std::string& name);
  void send(const Confirm& request);
  void send_next();
  void show();
  void show_draft();

  const SteadyClock& clock_;
  RosLink& ros_;
  Widgets widgets_;
  LibraryController& library_;
  LessonModel lesson_;
  TeachingWish wish_;   // of the running lesson
  std::string viewed_;  // object whose further views are being taught; "": none
  int draft_shown_ = 0;
  QImage image_;  // of the draft, without annotations
};

}  // namespace mbncc::console
