// SPDX-License-Identifier: BSD-3-Clause
// Why something is found at a place or is not: the sentences, and what can be done with them.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace mbncc::console {

class ExplainPane : public QWidget {
  Q_OBJECT

 public:
  explicit ExplainPane(QWidget* parent = nullptr);

  /// The question is on its way.
  void ask();
  /// Lines of the answer, the verdict first; `answered`: it is one, else the reason why not.
  void show_answer(bool answered, const QString& lines);
  /// The miss was kept in a file.
  void show_saved(const QString& file);

 Q_SIGNALS:
  void save_wanted();
  void closed();

 private:
  QLabel *verdict_, *lines_, *saved_;
  QPushButton *save_, *close_;
};

}  // namespace mbncc::console
