// The learned objects as thumbnails: enable, rename, delete, declare the symmetry, and undo instead
// of questions.
#pragma once

#ifndef Q_MOC_RUN
#include "console/library_model.hpp"
#endif

#include <QComboBox>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>
#include <cstdint>

namespace mbncc::console {

class LibraryStrip : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryStrip(QWidget* parent = nullptr);

  void show_objects(const LibraryModel& library);

 Q_SIGNALS:
  void edit_wanted(mbncc_vision::EditObject::Request request);
  void symmetry_wanted(QString name, std::uint8_t symmetry);
  void undo_wanted();

 private:
  QListWidgetItem* make_item(const mbncc_vision::LearnedObject& object);
  QString chosen() const;
  void show_choice();
  void take_new_name(QListWidgetItem* item);

  QListWidget* list_;
  QComboBox* symmetry_;
  QPushButton *enable_, *rename_, *delete_, *undo_;
  bool filling_ = false;
};

}  // namespace mbncc::console
