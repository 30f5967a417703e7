// SPDX-License-Identifier: BSD-3-Clause
// What the operator does with the library: edits and their undo, export, import, what the
// trash has.
#pragma once

#ifndef Q_MOC_RUN
#include "console/library/library_model.hpp"
#include "console/ros_link.hpp"
#endif

#include <QObject>
#include <QString>

namespace mbncc::console {

class LibraryStrip;

class LibraryController : public QObject {
  Q_OBJECT

 public:
  /// `ros` and `strip` outlive it.
  LibraryController(RosLink& ros, LibraryStrip& strip, QObject* parent);

  const LibraryModel& library() const { return library_; }
  /// A lesson changed the object, which "Undo edit" can take back.
  void retaught(const std::string& name) { library_.retaught(name); }
  /// Gives the object its own min_score, 0: none.
  void set_threshold(const QString& name, double min_score);

 Q_SIGNALS:
  /// The answer to what the operator did.
  void told(bool success, QString sentence);
  void edited();
  /// A name is gone that a question may be about.
  void name_gone();

 private:
  using Edit = mbncc_vision::EditObject::Request;

  void take_edit(const Edit& request, bool success, const QString& message);
  void undo();
  void export_object(const QString& name);
  void import_object();
  void show_history(const QString& name);
  void show_deleted();
  void restore(const QString& name, std::uint32_t revision);

  RosLink& ros_;
  LibraryStrip& strip_;
  LibraryModel library_;
  QString folder_;
  bool undoing_ = false;
};

}  // namespace mbncc::console
