// SPDX-License-Identifier: BSD-3-Clause
#include "console/lesson/lesson_bar.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "console/library/object_name.hpp"
#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

constexpr int kWholeBar = 100;

QLabel* make_label(const QString& text, int points, bool bold) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setPointSize(points);
  font.setBold(bold);
  label->setFont(font);
  return label;
}

}  // namespace

LessonBar::LessonBar(QWidget* parent)
    : QWidget(parent),
      name_(new QLineEdit),
      height_(new QDoubleSpinBox),
      symmetry_(make_symmetry_box("Rotations at which the object looks the same")),
      teach_(make_button("&Teach", "Start a lesson, then take the object away",
                         "Alt+T, or Enter in the name")),
      cancel_(make_button("&Cancel", "End the lesson; nothing is stored", "Alt+C")),
      mark_(make_button("&Mark grasp", "Record where the gripper holds the object")),
      headline_(make_label("", 17, true)),
      detail_(make_label("", 10, false)),
      time_left_(make_label("", 11, false)),
      progress_(new QProgressBar),
      choices_(new ChoiceRow) {
  name_->setPlaceholderText("name (or leave empty)");
  name_->setToolTip("What the object is called in the library (Ctrl+N)");
  name_window(name_, "name");
  height_->setRange(0, 1000);
  height_->setSuffix(" mm high");
  height_->setDecimals(1);
  detail_->setWordWrap(true);
  // The height of two lines is fixed, so that the widgets below do not move; the tooltip shows
  // longer sentences completely.
  detail_->setFixedHeight(2 * detail_->fontMetrics().lineSpacing() + 4);
  detail_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  progress_->setRange(0, kWholeBar);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(6);
  QFont bold = teach_->font();
  bold.setBold(true);
  teach_->setFont(bold);

  auto* row = new QHBoxLayout;
  row->addWidget(name_, 2);
  row->addWidget(height_);
  row->addWidget(symmetry_);
  for (auto* button : {teach_, cancel_, mark_}) row->addWidget(button);
  auto* headline_row = new QHBoxLayout;
  headline_row->addWidget(headline_, 1);
  headline_row->addWidget(choices_);
  headline_row->addWidget(time_left_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addLayout(row);
  all->setSpacing(3);
  all->addLayout(headline_row);
  all->addWidget(progress_);
  all->addWidget(detail_);

  connect(name_, &QLineEdit::textEdited, this, &LessonBar::tidy_name);
  connect(name_, &QLineEdit::returnPressed, teach_, &QPushButton::click);
  connect(teach_, &QPushButton::clicked, this, &LessonBar::teach_wanted);
  connect(cancel_, &QPushButton::clicked, this, &LessonBar::cancel_wanted);
  connect(mark_, &QPushButton::clicked, this, &LessonBar::mark_wanted);
}

void LessonBar::tidy_name(const QString& typed) {
  const TypedName tidy = usable_name(typed.toStdString());
  const QString name = QString::fromStdString(tidy.name);
  if (name != typed) {
    const int at = name_->cursorPosition() - (typed.size() - name.size());
    name_->setText(name);
    name_->setCursorPosition(at);
  }
  if (!tidy.complaint.empty()) say({Level::kDoubtful, tidy.complaint}, now_);
  Q_EMIT name_edited();
}

void LessonBar::set_name(const std::string& name) {
  name_->setText(QString::fromStdString(name));
}

void LessonBar::allow_marks(bool allowed, const QString& reason) {
  marks_allowed_ = allowed;
  mark_->setToolTip(allowed ? "Record where the gripper holds the object" : reason);
}

void LessonBar::clear_object() {
  name_->clear();
  height_->setValue(0);
  choose_symmetry(symmetry_, mbncc_vision::LearnObjectGoal::SYMMETRY_AUTO);
}

void LessonBar::show_goal(const mbncc_vision::LearnObjectGoal& goal) {
  height_->setValue(goal.object_height * 1000);
  choose_symmetry(symmetry_, goal.symmetry);
}

void LessonBar::say(const Notice::Line& line, double now) {
  notice_.post(line, now);
  show_detail(line);
}

void LessonBar::show_lesson(const LessonModel& lesson, double now) {
  now_ = now;
  teach_->setEnabled(lesson.may_teach());
  cancel_->setEnabled(lesson.may_cancel());
  mark_->setEnabled(marks_allowed_ && lesson.phase() != LessonModel::Phase::kNoServer);
  const bool asked = choices_->offers();
  headline_->setText(asked && !question_headline_.isEmpty()
                         ? question_headline_
                         : QString::fromStdString(lesson.headline()));
  const Notice::Line told{lesson.level(), lesson.detail()};
  show_detail(notice_.over(asked ? question_ : told, now));
  time_left_->setText(QString::fromStdString(lesson.time_left(now)));
  progress_->setValue(static_cast<int>(kWholeBar * lesson.progress()));
}

void LessonBar::ask(const QString& headline, const Notice::Line& question,
                    const std::vector<ChoiceRow::Answer>& answers) {
  question_headline_ = headline;
  question_ = question;
  choices_->offer(answers, mark_);
}

void LessonBar::take_keyboard() {
  name_->setFocus();
  name_->selectAll();
}

void LessonBar::show_detail(const Notice::Line& line) {
  detail_->setText(QString::fromStdString(line.text));
  detail_->setToolTip(detail_->text());
  show_alarm(detail_, line.level);
}

mbncc_vision::LearnObjectGoal LessonBar::goal() const {
  mbncc_vision::LearnObjectGoal goal;
  goal.name = name_->text().toStdString();
  goal.object_height = height_->value() / 1000;
  goal.symmetry = chosen_symmetry(symmetry_);
  goal.confirm = true;
  goal.allow_bad = true;  // the operator has been asked separately
  return goal;
}

}  // namespace mbncc::console
