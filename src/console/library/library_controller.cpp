// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/library_controller.hpp"

#include <QFileDialog>
#include <utility>

#include "console/library/library_strip.hpp"
#include "console/library/trash_dialog.hpp"
#include "mbncc/library/object_file.hpp"

namespace mbncc::console {
namespace {

QString threshold_sentence(const mbncc_vision::EditObject::Request& request) {
  const QString name = QString::fromStdString(request.name);
  if (request.clear) return "'" + name + "' no longer has its own min_score.";
  return QString("'%1' has its own min_score now, %2. Undo edit reverts it.")
      .arg(name)
      .arg(static_cast<double>(request.min_score), 0, 'f', 2);
}

QString object_files() {
  return QString("Objects (*%1)").arg(kObjectFileEnding);
}

}  // namespace

LibraryController::LibraryController(RosLink& ros, LibraryStrip& strip, QObject* parent)
    : QObject(parent), ros_(ros), strip_(strip) {
  connect(&ros, &RosLink::objects_listed, this,
          [this](const auto& objects, const QString& folder, quint64 inode) {
            folder_ = folder.toStdString();
            inode_ = inode;
            library_.set_objects(objects);
            strip_.show_objects(library_);
          });
  connect(&ros, &RosLink::edited, this, &LibraryController::take_edit);
  connect(&strip, &LibraryStrip::edit_wanted, this, [this](const auto& request) { send(request); });
  connect(&strip, &LibraryStrip::symmetry_wanted, this,
          [this](const QString& name, std::uint8_t symmetry) {
            send(library_.declare(name.toStdString(), symmetry));
          });
  connect(&strip, &LibraryStrip::undo_wanted, this, &LibraryController::undo);
  connect(&strip, &LibraryStrip::export_wanted, this, &LibraryController::export_object);
  connect(&strip, &LibraryStrip::import_wanted, this, &LibraryController::import_object);
  connect(&strip, &LibraryStrip::history_wanted, this, &LibraryController::show_history);
  connect(&strip, &LibraryStrip::deleted_wanted, this, &LibraryController::show_deleted);
}

void LibraryController::send(const Edit& request) {
  ++pending_;
  ros_.edit(request);
}

void LibraryController::take_edit(const Edit& request, bool settled, bool success,
                                  const QString& message) {
  --pending_;
  const bool undo = std::exchange(undoing_, false);
  if (success)
    Q_EMIT edited();
  else if (request.command == Edit::RENAME)
    strip_.complain("Not renamed: " + message);
  else
    Q_EMIT told(false, "Library: " + message);
  if (success && request.command == Edit::RENAME)
    strip_.choose(QString::fromStdString(request.new_name));
  if (success && request.command == Edit::RESTORE)
    strip_.choose(QString::fromStdString(request.name));
  if (success && (request.command == Edit::RENAME || request.command == Edit::DELETE))
    Q_EMIT name_gone();
  // An undo that failed for a passing reason can be repeated.
  if (undo && settled) library_.undone();
  if (!undo && success) library_.done(request);
  strip_.show_objects(library_);
  if (success && request.command == Edit::SET_THRESHOLD)
    Q_EMIT told(true, threshold_sentence(request));
}

void LibraryController::set_threshold(const QString& name, double min_score) {
  send(library_.set_threshold(name.toStdString(), min_score));
}

void LibraryController::undo() {
  // A pending edit is the one that the operator means, and its answer would be taken for the
  // undo's.
  if (!library_.can_undo() || pending_ > 0) return;
  undoing_ = true;
  send(library_.undo());
}

ListedLibrary LibraryController::listed() const {
  return {folder_, inode_, library_.objects()};
}

bool LibraryController::has_access() {
  try {
    check_library(listed());
    return true;
  } catch (const std::exception& error) {
    Q_EMIT told(false, error.what());
    return false;
  }
}

void LibraryController::export_object(const QString& name) {
  if (!has_access()) return;
  const QString file = QFileDialog::getSaveFileName(&strip_, "Export " + name,
                                                    name + kObjectFileEnding, object_files());
  if (file.isEmpty()) return;
  try {
    console::export_object(listed(), name.toStdString(), file.toStdString());
    Q_EMIT told(true, "Exported " + name + " to " + file);
  } catch (const std::exception& error) {
    Q_EMIT told(false, error.what());
  }
}

void LibraryController::import_object() {
  if (!has_access()) return;
  const QString file = QFileDialog::getOpenFileName(&strip_, "Import", "", object_files());
  if (file.isEmpty()) return;
  try {
    const auto name = console::import_object(listed(), file.toStdString());
    strip_.choose(QString::fromStdString(name));
    Q_EMIT told(true, "Imported " + QString::fromStdString(name));
    ros_.list_objects();
  } catch (const std::exception& error) {
    Q_EMIT told(false, error.what());
  }
}

void LibraryController::show_history(const QString& name) {
  try {
    const auto revisions = earlier_revisions(listed(), name.toStdString());
    auto* dialog =
        new TrashDialog("Earlier revisions of " + name,
                        revisions.empty() ? "There are none yet: a revision is kept whenever the "
                                            "object is taught again or its frame is moved."
                                          : "The newest is on top.",
                        &strip_);
    for (const auto& revision : revisions)
      dialog->add(revision, QString::fromStdString(revision.text));
    connect(dialog, &TrashDialog::restore_wanted, this, &LibraryController::restore);
    dialog->open();
  } catch (const std::exception& error) {
    Q_EMIT told(false, error.what());
  }
}

void LibraryController::show_deleted() {
  try {
    const auto objects = deleted_objects(listed());
    auto* dialog = new TrashDialog(
        "Deleted objects",
        objects.empty() ? "There are no deleted objects." : "Each is shown with its last revision.",
        &strip_);
    for (const auto& object : objects)
      dialog->add(object, QString::fromStdString(object.name + "\n" + object.text));
    connect(dialog, &TrashDialog::restore_wanted, this, &LibraryController::restore);
    dialog->open();
  } catch (const std::exception& error) {
    Q_EMIT told(false, error.what());
  }
}

void LibraryController::restore(const QString& name, std::uint32_t revision) {
  send(library_.restore(name.toStdString(), revision));
}

}  // namespace mbncc::console
