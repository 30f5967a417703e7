// SPDX-License-Identifier: BSD-3-Clause
// A question beside the lesson with its answers as buttons: what to do about a name that is taken,
// or whether another view follows. Its height stays, so that nothing below moves.
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

  /// Takes the place of the question before.
  void ask(const QString& question, const std::vector<Answer>& answers);
  void clear();
  bool asks() const { return !question_->text().isEmpty(); }

 private:
  QLabel* question_;
  QHBoxLayout* row_;
  std::vector<QPushButton*> buttons_;
};

}  // namespace mbncc::console
