// SPDX-License-Identifier: BSD-3-Clause
// The learned objects as thumbnails: search, enable, rename, delete, declare the symmetry, teach
// further views; undo instead of confirmation.
#pragma once

#ifndef Q_MOC_RUN
#include "console/library/library_model.hpp"
#endif

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QWidget>
#include <cstdint>

namespace mbncc::console {

class LibraryStrip : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryStrip(QWidget* parent = nullptr);

  /// Shows the objects, or after the operator has written a new name. `library` must outlive this.
  void show_objects(const LibraryModel& library);
  /// Selects an object once it is listed.
  void choose(const QString& name);
  /// Name of the selected object; "" for none.
  QString chosen() const;
  void allow_teaching(bool allowed);
  /// Shows what is wrong with a new name below the list; "": nothing. The next edit clears it.
  void complain(const QString& sentence);

 Q_SIGNALS:
  void edit_wanted(mbncc_vision::EditObject::Request request);
  void symmetry_wanted(QString name, std::uint8_t symmetry);
  void undo_wanted();
  /// The operator wants to teach a further view of the object.
  void view_wanted(QString name);
  void export_wanted(QString name);
  void import_wanted();
  void history_wanted(QString name);
  void deleted_wanted();

 private:
  QListWidgetItem* make_item(const mbncc_vision::LearnedObject& object);
  void lay_out();
  void connect_buttons();
  QMenu* make_menu();
  void show_choice();
  void filter();
  bool is_renaming() const;
  void take_new_name(QListWidgetItem* item);
  bool is_listed(const QString& name) const;

  QLineEdit* search_;
  QListWidget* list_;
  QLabel* complaint_;
  QComboBox* symmetry_;
  QPushButton *view_, *enable_, *rename_, *delete_, *undo_, *more_;
  QAction *export_, *history_;
  QString wanted_;
  const LibraryModel* waiting_ = nullptr;  // to show once no name is being written
  bool filling_ = false, teaching_allowed_ = false;
};

}  // namespace mbncc::console
