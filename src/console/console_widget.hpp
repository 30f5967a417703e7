// SPDX-License-Identifier: BSD-3-Clause
// The whole console: connects models, ROS link and widgets. It runs in its own window, or in RViz
// as TeachPanel.
#pragma once

#ifndef Q_MOC_RUN
#include "console/detections/lamps.hpp"
#include "console/image/live_image.hpp"
#include "console/image/marking_tool.hpp"
#include "console/lesson/lesson_model.hpp"
#include "console/lesson/teaching_wish.hpp"
#include "console/ros_link.hpp"
#endif

#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QTimer>
#include <QWidget>

namespace mbncc::console {

class CalibrationPane;
class DetectionsView;
class ExplainPane;
class LampRow;
class LessonBar;
class LibraryController;
class LibraryStrip;
class ImageView;
class ReviewPane;
class ThresholdController;
class ThresholdPane;

class ConsoleWidget : public QWidget {
  Q_OBJECT

 public:
  explicit ConsoleWidget(const Names& names, QWidget* parent = nullptr);
  ~ConsoleWidget() override;

 private:
  void lay_out();
  void fit_side();
  QWidget* make_image_bar();
  void make_shortcuts();
  QShortcut* on_key(const QKeySequence& keys, QWidget* where, const std::function<void()>& act);
  void connect_lesson();
  void connect_operator();
  void connect_library();
  void connect_cell();
  void connect_explanation();
  void connect_calibration();
  void connect_region();
  bool explains() const;

  double now() const { return clock_.elapsed() / 1000.0; }
  /// Shows the result of an action outside the lesson.
  void tell(bool success, const QString& sentence);
  void want_lesson();
  void ask_about_name(const std::string& name);
  void begin(const TeachingWish& wish);
  void end_lesson(const mbncc_vision::LearnObjectActionResult& result);
  void offer_next_view(const std::string& name);
  void next_view();
  void send(const mbncc_vision::ConfirmLearning::Request& request);
  void send_word(int command);
  void send_next();
  void withdraw_question();
  void take_tool(Tool tool);
  void escape();
  void ask_for_place();
  void ask_for_region();
  void show_region(const QRect& region);
  void show_explanation(bool success, const QString& lines, const QImage& image);
  void end_explanation();
  void begin_thresholds();
  void look_at_clock();
  void warn_of_old_image();
  void show_lesson();
  void show_draft();
  void end_review();
  QString live_caption(bool searched) const;
  void show_live(const QImage& image, QSize size,
                 const mbncc_vision::DetectedObjectArray* detections);

  QElapsedTimer clock_;
  LessonModel lesson_;
  Lamps lamps_;
  TeachingWish wish_;   // of the running lesson
  std::string viewed_;  // object whose further views are being taught; "": none
  int draft_shown_ = 0;
  LiveImage live_;
  double detections_at_ = -1e9, detections_age_ = 0, image_at_ = -1e9;
  QRect searched_;       // [px] region; empty: the whole image
  QImage lesson_image_;  // of the draft, without annotations
  QString explained_caption_, origin_warning_;

  LampRow* lamp_row_;
  LessonBar* lesson_bar_;
  ImageView* image_;
  ReviewPane* review_;
  ExplainPane* explanation_;
  ThresholdPane* threshold_pane_;
  CalibrationPane* calibration_;
  LibraryStrip* strip_;
  DetectionsView* detections_;
  QStackedWidget* side_;
  QWidget* cell_page_;
  LibraryController* library_;
  ThresholdController* threshold_controller_;
  QPushButton *marks_, *fit_, *why_, *thresholds_, *camera_, *region_;
  QShortcut* space_ = nullptr;
  QTimer timer_;
  RosLink ros_;  // last member, so that its threads end before the objects that they call
};

}  // namespace mbncc::console
