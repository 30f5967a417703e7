// SPDX-License-Identifier: BSD-3-Clause
// The answers to a question about the lesson as buttons: what to do about a name that is taken, or
// whether another view follows. The row keeps its height, so that nothing below moves.
#pragma once

#include <QHBoxLayout>
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

  /// Replaces the earlier answers; Tab reaches them from `previous`.
  void offer(const std::vector<Answer>& answers, QWidget* previous);
  void clear();
  bool offers() const { return !buttons_.empty(); }
  /// Gives the focus to the last answer.
  void take_keyboard();

 private:
  QHBoxLayout* row_;
  std::vector<QPushButton*> buttons_;
};

}  // namespace mbncc::console
