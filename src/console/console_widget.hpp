// The whole console: puts models, ROS link and widgets together. It lives in RViz as TeachPanel.
#pragma once

#ifndef Q_MOC_RUN
#include "console/lamps.hpp"
#include "console/lesson_model.hpp"
#include "console/library_model.hpp"
#include "console/live_picture.hpp"
#include "console/ros_link.hpp"
#endif

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

namespace mbncc::console {

class DetectionsView;
class LampRow;
class LessonBar;
class LibraryStrip;
class PictureView;
class ReviewPane;

class ConsoleWidget : public QWidget {
  Q_OBJECT

 public:
  explicit ConsoleWidget(const Names& names, QWidget* parent = nullptr);
  ~ConsoleWidget() override;

 private:
  void lay_out();
  void connect_lesson();
  void connect_operator();
  void connect_library();
  void connect_cell();

  double now() const { return clock_.elapsed() / 1000.0; }
  /// The answer to what the operator did beside the lesson.
  void tell(bool success, const QString& sentence);
  void teach();
  void send(const mbncc_vision::ConfirmLearning::Request& request);
  void take_edit(const mbncc_vision::EditObject::Request& request, bool success,
                 const QString& message);
  void undo_edit();
  void look_at_clock();
  void show_lesson();
  void show_draft(const mbncc_vision::LearnObjectResult& draft);
  void show_live(const QImage& picture, bool searched);

  QElapsedTimer clock_;
  LessonModel lesson_;
  LibraryModel library_;
  Lamps lamps_;
  bool undoing_ = false;
  int draft_shown_ = 0;
  LivePicture live_;
  double detections_at_ = -1e9;

  LampRow* lamp_row_;
  LessonBar* lesson_bar_;
  PictureView* picture_;
  ReviewPane* review_;
  LibraryStrip* strip_;
  DetectionsView* detections_;
  QTimer timer_;
  RosLink ros_;  // last: its threads end before what they speak to
};

}  // namespace mbncc::console
