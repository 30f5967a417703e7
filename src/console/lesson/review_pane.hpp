// SPDX-License-Identifier: BSD-3-Clause
// The operator's review before an object is stored: verdict, reasons, template, score map; accept,
// reject, correct.
#pragma once

#ifndef Q_MOC_RUN
#include "console/image/marking_tool.hpp"
#include "console/lesson/lesson_model.hpp"
#endif

#include <QButtonGroup>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

namespace mbncc::console {

class ScaledImage;

class ReviewPane : public QWidget {
  Q_OBJECT

 public:
  explicit ReviewPane(QWidget* parent = nullptr);

  void show_lesson(const LessonModel& lesson);
  void show_score_map(const QImage& map);
  void choose_tool(Tool tool);

 Q_SIGNALS:
  /// `command` of ConfirmLearning: ACCEPT, REJECT or UNDO.
  void decided(int command);
  void insisted(bool insisted);
  void tool_chosen(int tool);
  void stroke_width_chosen(int width);

 private:
  void lay_out();
  QWidget* make_tools();
  void show_draft(const mbncc_vision::LearnObjectResult& draft);
  void put_tool_down();

  QLabel *verdict_, *numbers_, *reasons_;
  ScaledImage *template_, *score_map_;
  QCheckBox* insist_;
  QPushButton *accept_, *reject_, *undo_;
  QButtonGroup* tools_;
  QSlider* width_;
  int draft_shown_ = 0;
};

}  // namespace mbncc::console
