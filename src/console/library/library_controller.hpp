// SPDX-License-Identifier: BSD-3-Clause
// Carries out the operator's actions on the library: edits and their undo, export, import, and
// restoring from the trash.
#pragma once

#ifndef Q_MOC_RUN
#include "console/library/library_files.hpp"
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
  /// `ros` and `strip` must outlive it.
  LibraryController(RosLink& ros, LibraryStrip& strip, QObject* parent);

  const LibraryModel& library() const { return library_; }
  /// A lesson about that name begins.
  void begin_lesson(const std::string& name) { library_.begin_lesson(name); }
  /// The lesson stored the object; "Undo edit" can revert this if there was one before.
  void retaught(const std::string& name) { library_.retaught(name); }
  /// The learning nodelet has ended; its successor may use another folder.
  void forget_folder() { folder_.clear(); }
  /// Gives the object its own min_score; 0 removes it.
  void set_threshold(const QString& name, double min_score);

 Q_SIGNALS:
  /// The result of an action of the operator.
  void told(bool success, QString sentence);
  void edited();
  /// A name no longer exists; a pending question may refer to it.
  void name_gone();

 private:
  using Edit = mbncc_vision::EditObject::Request;

  void send(const Edit& request);
  void take_edit(const Edit& request, bool settled, bool success, const QString& message);
  void undo();
  ListedLibrary listed() const;
  /// Whether this computer has access to the library's folder; says so if it has not.
  bool has_access();
  void export_object(const QString& name);
  void import_object();
  void show_history(const QString& name);
  void show_deleted();
  void restore(const QString& name, std::uint32_t revision);

  RosLink& ros_;
  LibraryStrip& strip_;
  LibraryModel library_;
  std::string folder_;  // that the learning nodelet names; "": none yet
  std::uint64_t inode_ = 0;
  int pending_ = 0;  // edits that are not answered yet
  bool undoing_ = false;
};

}  // namespace mbncc::console
