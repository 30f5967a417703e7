// SPDX-License-Identifier: BSD-3-Clause
// A question with its answers as buttons: what to do about an existing name, or whether another
// view follows. Its height is constant, so that widgets below do not move.
#pragma once

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <functional>
#include <vector>

namespace mbncc::console {

class ChoiceRow : public QWidget {
  Q_OBJECT

 public:
  struct Answer {
    QString text, tip;
    std::function<void()> act;
  };

  explicit ChoiceRow(QWidget* parent = nullptr);

  /// Replaces the previous question.
  void ask(const QString& question, const std::vector<Answer>& answers);
  void clear();
  bool asks() const { return !question_->text().isEmpty(); }

 private:
  QLabel* question_;
  QHBoxLayout* row_;
  std::vector<QPushButton*> buttons_;
};

}  // namespace mbncc::console
