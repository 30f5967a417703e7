// SPDX-License-Identifier: BSD-3-Clause
#include "console/thresholds/threshold_pane.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <cmath>

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

}  // namespace

ThresholdPane::ThresholdPane(QWidget* parent)
    : QWidget(parent),
      min_text_(new QLabel),
      confirm_text_(new QLabel),
      summary_(new QLabel),
      min_(make_slider("min_score")),
      confirm_(make_slider("confirm_score")),
      all_(new QRadioButton("for all objects")),
      one_(new QRadioButton),
      object_text_(new QLabel) {
  QFont bold = summary_->font();
  bold.setBold(true);
  summary_->setFont(bold);
  summary_->setWordWrap(true);
  auto* apply = make_button("Appl&y", "The matcher uses it from now on", "Alt+Y");
  auto* close = make_button("&Close", "Nothing is changed; show the live pictures", "Esc");
  auto* row = new QHBoxLayout;
  row->addWidget(apply);
  row->addWidget(close);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(min_text_);
  all->addWidget(min_);
  all->addWidget(confirm_text_);
  all->addWidget(confirm_);
  all->addWidget(all_);
  all->addWidget(one_);
  all->addWidget(object_text_);
  all->addWidget(summary_);
  all->addStretch(1);
  all->addLayout(row);
  for (auto* slider : {min_, confirm_})
    connect(slider, &QSlider::valueChanged, this, [this] {
      tell();
      Q_EMIT moved();
    });
  connect(one_, &QRadioButton::toggled, confirm_, &QWidget::setDisabled);
  connect(apply, &QPushButton::clicked, this,
          [this] { Q_EMIT apply_wanted(one_->isChecked() ? object_ : QString()); });
  connect(close, &QPushButton::clicked, this, &ThresholdPane::closed);
}

void ThresholdPane::begin(const Thresholds& now, const QString& object) {
  object_ = object;
  all_->setChecked(true);
  one_->setText(object.isEmpty() ? "for one object: choose it in the library first"
                                 : "min_score for the chosen object alone:");
  object_text_->setText(object);
  one_->setEnabled(!object.isEmpty());
  min_->setValue(static_cast<int>(std::lround(kSteps * now.min_score)));
  confirm_->setValue(static_cast<int>(std::lround(kSteps * now.confirm_score)));
  tell();
}

Thresholds ThresholdPane::wanted() const {
  return {static_cast<double>(min_->value()) / kSteps,
          static_cast<double>(confirm_->value()) / kSteps};
}

void ThresholdPane::tell() {
  min_text_->setText(QString("Least score of reported detections: %1 (min_score)")
                         .arg(wanted().min_score, 0, 'f', 2));
  confirm_text_->setText(QString("Least score of graspable detections: %1 (confirm_score)")
                             .arg(wanted().confirm_score, 0, 'f', 2));
}

}  // namespace mbncc::console
