// SPDX-License-Identifier: BSD-3-Clause
#include "console/lesson/choice_row.hpp"

#include "console/widgets.hpp"

namespace mbncc::console {

ChoiceRow::ChoiceRow(QWidget* parent) : QWidget(parent), row_(new QHBoxLayout(this)) {
  row_->setContentsMargins(0, 0, 0, 0);
  setFixedHeight(fontMetrics().lineSpacing() + 14);
}

void ChoiceRow::offer(const std::vector<Answer>& answers, QWidget* previous) {
  clear();
  for (const auto& answer : answers) {
    auto* button = make_button(answer.text, answer.tip);
    row_->addWidget(button);
    QWidget::setTabOrder(previous, button);
    previous = button;
    buttons_.push_back(button);
    connect(button, &QPushButton::clicked, this, [this, act = answer.act] {
      clear();
      act();
    });
  }
}

void ChoiceRow::clear() {
  // The clicked button is still in its handler, so it must not be deleted here.
  for (auto* button : buttons_) {
    button->hide();
    button->deleteLater();
  }
  buttons_.clear();
}

void ChoiceRow::take_keyboard() {
  // Qt::TabFocusReason makes the focus frame visible.
  if (offers()) buttons_.back()->setFocus(Qt::TabFocusReason);
}

}  // namespace mbncc::console
