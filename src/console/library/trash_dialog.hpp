// SPDX-License-Identifier: BSD-3-Clause
// Lists the contents of the trash and restores one: earlier revisions of an object, or deleted
// objects.
#pragma once

#ifndef Q_MOC_RUN
#include "console/library/library_files.hpp"
#endif

#include <QDialog>
#include <QListWidget>
#include <QString>
#include <cstdint>

namespace mbncc::console {

class TrashDialog : public QDialog {
  Q_OBJECT

 public:
  TrashDialog(const QString& title, const QString& text, QWidget* parent = nullptr);

  /// `label`: the text beside the image.
  void add(const Revision& revision, const QString& label);

 Q_SIGNALS:
  void restore_wanted(QString name, std::uint32_t revision);

 private:
  void restore();

  QListWidget* list_;
  QPushButton* restore_;
};

}  // namespace mbncc::console
