// SPDX-License-Identifier: BSD-3-Clause
#include "console/thresholds/threshold_pane.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <cmath>
#include <initializer_list>

#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

constexpr int kSteps = 100;  // of a slider, from 0 to 1

QSlider* make_slider(const QString& name) {
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setRange(1, kSteps);
  slider->setPageStep(5);
  name_window(slider, name);
  return slider;
}

int steps_of(double score) {
  return static_cast<int>(std::lround(kSteps * score));
}

}  // namespace

ThresholdPane::ThresholdPane(QWidget* parent)
    : QWidget(parent),
      min_text_(new QLabel),
      confirm_text_(new QLabel),
      summary_(new QLabel),
      min_(make_slider("min_score")),
      confirm_(make_slider("confirm_score")),
      all_(new QRadioButton("for all objects without a min_score of their own")),
      one_(new QRadioButton),
      inherit_(new QCheckBox("no min_score of its own: that of all objects applies")),
      object_text_(new QLabel) {
  QFont bold = summary_->font();
  bold.setBold(true);
  summary_->setFont(bold);
  summary_->setWordWrap(true);
  name_window(one_, "one object");
  name_window(inherit_, "as all");
  lay_out();
  for (auto* slider : {min_, confirm_})
    connect(slider, &QSlider::valueChanged, this, [this] {
      tell();
      Q_EMIT moved();
    });
  connect(one_, &QRadioButton::toggled, this, &ThresholdPane::set_scope);
  connect(inherit_, &QCheckBox::toggled, this, [this](bool inherits) {
    min_->setDisabled(inherits);
    tell();
    Q_EMIT moved();
  });
}

void ThresholdPane::lay_out() {
  auto* apply = make_button("Appl&y", "The matcher uses it from now on", "Alt+Y");
  auto* close = make_button("&Close", "Nothing is changed; show the live images", "Esc");
  connect(apply, &QPushButton::clicked, this, &ThresholdPane::apply_wanted);
  connect(close, &QPushButton::clicked, this, &ThresholdPane::closed);
  auto* row = new QHBoxLayout;
  row->addWidget(apply);
  row->addWidget(close);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  for (QWidget* widget : std::initializer_list<QWidget*>{
           min_text_, min_, confirm_text_, confirm_, all_, one_, object_text_, inherit_, summary_})
    all->addWidget(widget);
  all->addStretch(1);
  all->addLayout(row);
}

void ThresholdPane::begin(const Thresholds& now, const QString& object) {
  object_ = object;
  now_ = now;
  one_->setText(object.isEmpty() ? "for one object: choose it in the library first"
                                 : "min_score only for the chosen object:");
  object_text_->setText(object);
  one_->setEnabled(!object.isEmpty());
  confirm_->setValue(steps_of(now.confirm_score));
  all_->setChecked(true);
  set_scope();
}

/// The slider shows the current value, for all objects or for the chosen one.
void ThresholdPane::set_scope() {
  const bool one = one_->isChecked();
  const std::string name = object_.toStdString();
  confirm_->setDisabled(one);
  inherit_->setVisible(one && now_.own.count(name) != 0);
  inherit_->setChecked(false);
  min_->setDisabled(false);
  min_->setValue(steps_of(one ? now_.min_score_of(name) : now_.min_score));
  tell();
  Q_EMIT moved();
}

Thresholds ThresholdPane::wanted() const {
  Thresholds wanted = now_;
  const double least = static_cast<double>(min_->value()) / kSteps;
  if (!one_->isChecked()) {
    wanted.min_score = least;
    wanted.confirm_score = static_cast<double>(confirm_->value()) / kSteps;
  } else if (inherit_->isChecked()) {
    wanted.own.erase(object_.toStdString());
  } else {
    wanted.own[object_.toStdString()] = least;
  }
  return wanted;
}

void ThresholdPane::tell() {
  const Thresholds wanted = this->wanted();
  const double least =
      one_->isChecked() ? wanted.min_score_of(object_.toStdString()) : wanted.min_score;
  min_text_->setText(
      QString("Least score of reported detections: %1 (min_score)").arg(least, 0, 'f', 2));
  confirm_text_->setText(QString("Least score of graspable detections: %1 (confirm_score)")
                             .arg(wanted.confirm_score, 0, 'f', 2));
}

}  // namespace mbncc::console
