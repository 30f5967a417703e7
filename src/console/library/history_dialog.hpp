// SPDX-License-Identifier: BSD-3-Clause
// Lists earlier revisions of an object and restores one.
#pragma once

#ifndef Q_MOC_RUN
#include "console/library/library_files.hpp"
#endif

#include <QDialog>
#include <QListWidget>
#include <QString>

namespace mbncc::console {

class HistoryDialog : public QDialog {
  Q_OBJECT

 public:
  HistoryDialog(const QString& name, const std::vector<Revision>& revisions,
                QWidget* parent = nullptr);

 Q_SIGNALS:
  void revision_wanted(int number);

 private:
  QListWidget* list_;
};

}  // namespace mbncc::console
