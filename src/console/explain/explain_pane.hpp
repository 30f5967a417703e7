// SPDX-License-Identifier: BSD-3-Clause
// Explains why an object is found at a place or not, with buttons to ask and to save.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace mbncc::console {

class ExplainPane : public QWidget {
  Q_OBJECT

 public:
  explicit ExplainPane(QWidget* parent = nullptr);

  /// Call this when the question has been sent.
  void ask();
  /// Lines of the answer, the result first; `answered` is false if they give the reason of a
  /// failure.
  void show_answer(bool answered, const QString& lines);
  /// Call this when the miss has been saved in a file.
  void show_saved(const QString& file);

 Q_SIGNALS:
  void save_wanted();
  void closed();

 private:
  QLabel *verdict_, *lines_, *saved_;
  QPushButton *save_, *close_;
};

}  // namespace mbncc::console
