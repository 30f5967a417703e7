// SPDX-License-Identifier: BSD-3-Clause
// The explanation why an object is found at a place or not, and the buttons for it.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace mbncc::console {

class ExplainPane : public QWidget {
  Q_OBJECT

 public:
  explicit ExplainPane(QWidget* parent = nullptr);

  /// The question was sent.
  void ask();
  /// Lines of the answer, the result first; `answered`: false if it is the reason of a failure.
  void show_answer(bool answered, const QString& lines);
  /// The miss was saved in a file.
  void show_saved(const QString& file);

 Q_SIGNALS:
  void save_wanted();
  void closed();

 private:
  QLabel *verdict_, *lines_, *saved_;
  QPushButton *save_, *close_;
};

}  // namespace mbncc::console
