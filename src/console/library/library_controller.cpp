// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/library_controller.hpp"

#include <QFileDialog>

#include "console/library/history_dialog.hpp"
#include "console/library/library_files.hpp"
#include "console/library/library_strip.hpp"

namespace mbncc::console {

LibraryController::LibraryController(RosLink& ros, LibraryStrip& strip, QObject* parent)
    : QObject(parent), ros_(ros), strip_(strip) {
  connect(&ros, &RosLink::objects_listed, this, [this](const auto& objects, const auto& folder) {
    folder_ = folder;
    library_.set_objects(objects);
    strip_.show_objects(library_);
  });
  connect(&ros, &RosLink::edited, this, &LibraryController::take_edit);
  connect(&strip, &LibraryStrip::edit_wanted, this,
          [this](const auto& request) { ros_.edit(request); });
  connect(&strip, &LibraryStrip::symmetry_wanted, this,
          [this](const QString& name, std::uint8_t symmetry) {
            ros_.edit(library_.declare(name.toStdString(), symmetry));
          });
  connect(&strip, &LibraryStrip::undo_wanted, this, &LibraryController::undo);
  connect(&strip, &LibraryStrip::export_wanted, this, &LibraryController::export_object);
  connect(&strip, &LibraryStrip::import_wanted, this, &LibraryController::import_object);
  connect(&strip, &LibraryStrip::history_wanted, this, &LibraryController::show_history);
}

void LibraryController::take_edit(const Edit& request, bool success, const QString& message) {
  const bool undone = undoing_;
  undoing_ = false;
  if (success)
    Q_EMIT edited();
  else
    Q_EMIT told(false, "Library: " + message);
  if (success && request.command == Edit::RENAME)
    strip_.choose(QString::fromStdString(request.new_name));
  if (success && request.command == Edit::RESTORE)
    strip_.choose(QString::fromStdString(request.name));
  if (success && (request.command == Edit::RENAME || request.command == Edit::DELETE))
    Q_EMIT name_gone();
  if (undone)
    library_.undone();
  else if (success)
    library_.done(request);
  strip_.show_objects(library_);
}

void LibraryController::undo() {
  if (!library_.can_undo() || undoing_) return;
  undoing_ = true;
  ros_.edit(library_.undo());
}

void LibraryController::export_object(const QString& name) {
  const QString file =
      QFileDialog::getSaveFileName(&strip_, "Export " + name, name + ".png", "Objects (*.png)");
  if (file.isEmpty()) return;
  try {
    console::export_object(folder_.toStdString(), name.toStdString(), file.toStdString());
    Q_EMIT told(true, "Exported " + name + " to " + file);
  } catch (const std::exception& error) {
    Q_EMIT told(false, error.what());
  }
}

void LibraryController::import_object() {
  const QString file = QFileDialog::getOpenFileName(&strip_, "Import", "", "Objects (*.png)");
  if (file.isEmpty()) return;
  try {
    const auto name = console::import_object(folder_.toStdString(), file.toStdString());
    strip_.choose(QString::fromStdString(name));
    Q_EMIT told(true, "Imported " + QString::fromStdString(name));
    ros_.list_objects();
  } catch (const std::exception& error) {
    Q_EMIT told(false, error.what());
  }
}

void LibraryController::show_history(const QString& name) {
  try {
    auto* dialog = new HistoryDialog(
        name, earlier_revisions(folder_.toStdString(), name.toStdString()), &strip_);
    connect(dialog, &HistoryDialog::revision_wanted, this, [this, name](int number) {
      Edit request;
      request.name = name.toStdString();
      request.command = Edit::RESTORE;
      request.revision = static_cast<std::uint32_t>(number);
      library_.retaught(request.name);
      ros_.edit(request);
    });
    dialog->open();
  } catch (const std::exception& error) {
    Q_EMIT told(false, error.what());
  }
}

}  // namespace mbncc::console
