// SPDX-License-Identifier: BSD-3-Clause
#include "console/lesson/choice_row.hpp"

#include "console/widgets.hpp"

namespace mbncc::console {

ChoiceRow::ChoiceRow(QWidget* parent)
    : QWidget(parent), question_(new QLabel), row_(new QHBoxLayout(this)) {
  row_->setContentsMargins(0, 0, 0, 0);
  QFont bold = question_->font();
  bold.setBold(true);
  question_->setFont(bold);
  row_->addWidget(question_);
  setFixedHeight(question_->fontMetrics().lineSpacing() + 14);
}

void ChoiceRow::ask(const QString& question, const std::vector<Answer>& answers) {
  clear();
  question_->setText(question);
  for (const auto& answer : answers) {
    auto* button = make_button(answer.text, answer.tip, this);
    row_->addWidget(button);
    buttons_.push_back(button);
    connect(button, &QPushButton::clicked, this, [this, act = answer.act] {
      clear();
      act();
    });
  }
}

void ChoiceRow::clear() {
  question_->clear();
  // The clicked button is still in its handler.
  for (auto* button : buttons_) {
    button->hide();
    button->deleteLater();
  }
  buttons_.clear();
}

}  // namespace mbncc::console
