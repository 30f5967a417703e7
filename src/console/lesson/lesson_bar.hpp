// SPDX-License-Identifier: BSD-3-Clause
// The bar for a lesson: name, height, Teach; the current instruction, progress and remaining time.
#pragma once

#ifndef Q_MOC_RUN
#include <mbncc_vision/LearnObjectGoal.h>

#include "console/lesson/choice_row.hpp"
#include "console/lesson/lesson_model.hpp"
#include "console/notice.hpp"
#endif

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

namespace mbncc::console {

class LessonBar : public QWidget {
  Q_OBJECT

 public:
  explicit LessonBar(QWidget* parent = nullptr);

  void show_lesson(const LessonModel& lesson, double now);
  mbncc_vision::LearnObjectGoal goal() const;
  void set_name(const std::string& name);
  /// Whether Mark grasp is possible; `reason`: why it is not.
  void allow_marks(bool allowed, const QString& reason);
  /// Shows a question instead of the lesson's own sentence, until it is answered or withdrawn.
  /// `headline` replaces the lesson's headline; "" keeps that.
  void ask(const QString& headline, const Notice::Line& question,
           const std::vector<ChoiceRow::Answer>& answers);
  void withdraw_question() { choices_->clear(); }
  /// Gives the focus to the name.
  void take_keyboard();
  /// Gives the focus to the last answer.
  void give_keyboard_to_answers() { choices_->take_keyboard(); }
  /// Clears the notice when it is out of date.
  void clear_notice() { notice_.clear(); }
  /// Clears name, height and declared symmetry, which belong to the object of one lesson.
  void clear_object();
  /// Shows the height and the symmetry of a lesson that is sent.
  void show_goal(const mbncc_vision::LearnObjectGoal& goal);
  /// Shows a notice, such as the library's refusal, instead of the lesson's own message for some
  /// seconds.
  void say(const Notice::Line& line, double now);

 Q_SIGNALS:
  void teach_wanted();
  void cancel_wanted();
  void mark_wanted();
  /// The operator edited the name.
  void name_edited();

 private:
  void show_detail(const Notice::Line& line);
  void tidy_name(const QString& typed);

  Notice notice_;
  Notice::Line question_;  // shown while there are answers, as is its headline
  QString question_headline_;
  QLineEdit* name_;
  QDoubleSpinBox* height_;
  QComboBox* symmetry_;
  QPushButton *teach_, *cancel_, *mark_;
  QLabel *headline_, *detail_, *time_left_;
  QProgressBar* progress_;
  ChoiceRow* choices_;
  bool marks_allowed_ = false;
  double now_ = 0;
};

}  // namespace mbncc::console
