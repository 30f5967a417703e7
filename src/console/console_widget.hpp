// SPDX-License-Identifier: BSD-3-Clause
// The whole console: connects models, ROS link and widgets. It runs in its own window, or in RViz
// as TeachPanel.
#pragma once

#ifndef Q_MOC_RUN
#include "console/detections/lamps.hpp"
#include "console/image/live_image.hpp"
#include "console/ros_link.hpp"
#include "console/steady_clock.hpp"
#endif

#include <QShortcut>
#include <QStackedWidget>
#include <QTimer>
#include <QWidget>

namespace mbncc::console {

class CalibrationPane;
class DetectionsView;
class ExplainPane;
class LampRow;
class ImageBar;
class ImageView;
class LessonBar;
class LessonController;
class LibraryController;
class LibraryStrip;
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
  void make_shortcuts();
  QShortcut* on_key(const QKeySequence& keys, QWidget* where, const std::function<void()>& act);
  void connect_lesson();
  void connect_library();
  void connect_cell();
  void connect_explanation();
  void connect_calibration();
  void connect_region();
  bool explains() const;

  double now() const { return clock_.now(); }
  /// Shows the result of an action outside the lesson.
  void tell(bool success, const QString& sentence);
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
  void show_review();
  QString live_caption(bool searched) const;
  void show_live(const QImage& image, QSize size,
                 const mbncc_vision::DetectedObjectArray* detections);

  SteadyClock clock_;
  Lamps lamps_;
  LiveImage live_;
  double detections_at_ = -1e9, detections_age_ = 0, image_at_ = -1e9;
  QRect searched_;  // [px] region; empty: the whole image
  QString explained_caption_, origin_warning_;

  LampRow* lamp_row_;
  LessonBar* lesson_bar_;
  ImageView* image_;
  ImageBar* image_bar_;
  ReviewPane* review_;
  ExplainPane* explanation_;
  ThresholdPane* threshold_pane_;
  CalibrationPane* calibration_;
  LibraryStrip* strip_;
  DetectionsView* detections_;
  QStackedWidget* side_;
  QWidget* cell_page_;
  LibraryController* library_;
  LessonController* lesson_;
  ThresholdController* threshold_controller_;
  QShortcut* space_ = nullptr;
  QTimer timer_;
  RosLink ros_;  // last member, so that its threads end before the objects that they call
};

}  // namespace mbncc::console
