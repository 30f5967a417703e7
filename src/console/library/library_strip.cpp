// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/library_strip.hpp"

#include <QHBoxLayout>
#include <QPainter>
#include <QTimer>
#include <QVBoxLayout>

#include "console/image/images.hpp"
#include "console/image/scaled_image.hpp"
#include "console/library/object_name.hpp"
#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

constexpr int kNameRole = Qt::UserRole, kEnabledRole = Qt::UserRole + 1,
              kSymmetryRole = Qt::UserRole + 2;
constexpr QSize kIcon(64, 64);

QPixmap icon_of(const mbncc_vision::LearnedObject& object) {
  QPixmap icon(kIcon);
  icon.fill(QColor("#303030"));
  const QImage image = to_qimage(to_rgb(object.thumbnail));
  QPainter painter(&icon);
  if (!image.isNull()) {
    const QImage scaled = image.scaled(kIcon, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    painter.setOpacity(object.enabled ? 1 : 0.3);
    painter.drawImage((kIcon.width() - scaled.width()) / 2, (kIcon.height() - scaled.height()) / 2,
                      scaled);
    painter.setOpacity(1);
  }
  // The corner shows the verdict's level.
  const Level level = level_of_verdict(object.quality.verdict);
  painter.fillRect(0, 0, 20, 20, QColor(colour_of(level)));
  painter.setPen(QColor(ink_on(level)));
  painter.drawText(QRect(0, 0, 20, 20), Qt::AlignCenter, QString::fromUtf8(symbol_of(level)));
  painter.setPen(Qt::white);
  if (!object.enabled)
    painter.drawText(icon.rect(), Qt::AlignBottom | Qt::AlignHCenter, "disabled");
  return icon;
}

}  // namespace

LibraryStrip::LibraryStrip(QWidget* parent)
    : QWidget(parent),
      search_(new QLineEdit),
      list_(new QListWidget),
      complaint_(new QLabel),
      symmetry_(make_symmetry_box("Rotations at which the chosen object looks the same")),
      view_(make_button("Teach &view",
                        "Teach the chosen object in different light or slightly rotated", "Alt+V")),
      enable_(
          make_button("&Disable", "Enable or disable the search for the chosen object", "Alt+D")),
      rename_(make_button("Re&name", "Write a new name below its image", "F2")),
      delete_(make_button("De&lete", "Remove it from the library; Undo edit restores it", "Alt+L")),
      undo_(make_button("Undo &edit", "Undo the last change of the library", "Alt+E")),
      more_(make_button("M&ore", "Export, import, earlier revisions, deleted objects", "Alt+O")) {
  search_->setPlaceholderText("search the library");
  search_->setClearButtonEnabled(true);
  list_->setViewMode(QListView::IconMode);
  list_->setResizeMode(QListView::Adjust);
  list_->setMovement(QListView::Static);
  list_->setIconSize(kIcon);
  list_->setTextElideMode(Qt::ElideMiddle);
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  list_->setMinimumHeight(kIcon.height() + 34);
  name_window(list_, "library");
  name_window(search_, "search");
  complaint_->setWordWrap(true);
  show_alarm(complaint_, Level::kDoubtful);
  complain("");
  lay_out();
  connect_buttons();
  show_choice();
  undo_->setEnabled(false);
}

void LibraryStrip::lay_out() {
  auto* first = new QHBoxLayout;
  for (auto* button : {view_, enable_, rename_, delete_}) first->addWidget(button);
  auto* second = new QHBoxLayout;
  second->addWidget(symmetry_, 1);
  for (auto* button : {undo_, more_}) second->addWidget(button);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(3);
  all->addWidget(search_);
  all->addWidget(list_, 1);
  all->addWidget(complaint_);
  all->addLayout(first);
  all->addLayout(second);
}

QMenu* LibraryStrip::make_menu() {
  auto* menu = new QMenu(this);
  name_window(menu, "menu of More");
  export_ = menu->addAction("Export the chosen object as a file ...");
  auto* import = menu->addAction("Import an object from a file ...");
  history_ = menu->addAction("Earlier revisions of the chosen object ...");
  auto* deleted = menu->addAction("Deleted objects ...");
  connect(export_, &QAction::triggered, [this] { Q_EMIT export_wanted(chosen()); });
  connect(import, &QAction::triggered, this, &LibraryStrip::import_wanted);
  connect(history_, &QAction::triggered, [this] { Q_EMIT history_wanted(chosen()); });
  connect(deleted, &QAction::triggered, this, &LibraryStrip::deleted_wanted);
  return menu;
}

void LibraryStrip::connect_buttons() {
  more_->setMenu(make_menu());
  connect(search_, &QLineEdit::textChanged, this, &LibraryStrip::filter);
  connect(list_, &QListWidget::itemSelectionChanged, this, &LibraryStrip::show_choice);
  connect(list_, &QListWidget::itemChanged, this, &LibraryStrip::take_new_name);
  // Later, because the list still handles the end of the editor.
  connect(list_->itemDelegate(), &QAbstractItemDelegate::closeEditor, this, [this] {
    QTimer::singleShot(0, this, [this] {
      if (waiting_ != nullptr) show_objects(*waiting_);
    });
  });
  connect(view_, &QPushButton::clicked, [this] { Q_EMIT view_wanted(chosen()); });
  connect(enable_, &QPushButton::clicked, [this] {
    const bool enabled = list_->currentItem()->data(kEnabledRole).toBool();
    Q_EMIT edit_wanted(LibraryModel::enable(chosen().toStdString(), !enabled));
  });
  connect(rename_, &QPushButton::clicked, [this] { list_->editItem(list_->currentItem()); });
  for (auto* button : {view_, enable_, rename_, delete_, undo_})
    connect(button, &QPushButton::clicked, [this] { complain(""); });
  connect(list_, &QListWidget::itemClicked, [this] { complain(""); });
  connect(delete_, &QPushButton::clicked,
          [this] { Q_EMIT edit_wanted(LibraryModel::remove(chosen().toStdString())); });
  connect(undo_, &QPushButton::clicked, this, &LibraryStrip::undo_wanted);
  // QComboBox::activated is emitted only for changes by the operator, not by show_choice().
  connect(symmetry_, QOverload<int>::of(&QComboBox::activated), [this] {
    const auto known = list_->currentItem()->data(kSymmetryRole).toUInt();
    if (chosen_symmetry(symmetry_) != known)
      Q_EMIT symmetry_wanted(chosen(), chosen_symmetry(symmetry_));
  });
}

void LibraryStrip::allow_teaching(bool allowed) {
  teaching_allowed_ = allowed;
  view_->setEnabled(allowed && !chosen().isEmpty());
}

void LibraryStrip::choose(const QString& name) {
  wanted_ = name;
}

void LibraryStrip::filter() {
  for (int row = 0; row < list_->count(); ++row)
    list_->item(row)->setHidden(
        !list_->item(row)->toolTip().contains(search_->text(), Qt::CaseInsensitive));
  // The buttons act on what the operator sees.
  const auto* current = list_->currentItem();
  if (current != nullptr && current->isHidden()) list_->setCurrentItem(nullptr);
}

bool LibraryStrip::is_renaming() const {
  const auto* editor = list_->viewport()->findChild<QLineEdit*>();
  return editor != nullptr && !editor->isHidden();
}

QString LibraryStrip::chosen() const {
  const auto* item = list_->currentItem();
  return item != nullptr && item->isSelected() ? item->data(kNameRole).toString() : QString();
}

QListWidgetItem* LibraryStrip::make_item(const mbncc_vision::LearnedObject& object) {
  const QString name = QString::fromStdString(object.name);
  const QString label = QString::fromStdString(object.label);
  auto* item = new QListWidgetItem(QIcon(icon_of(object)), name);
  item->setData(kNameRole, name);
  item->setData(kEnabledRole, object.enabled);
  item->setData(kSymmetryRole, object.symmetry);
  item->setFlags(item->flags() | Qt::ItemIsEditable);
  item->setSizeHint({kIcon.width() + 24, kIcon.height() + 24});  // long names are shortened
  item->setToolTip(QString("%1, revision %2, %3 view(s), verdict %4%5")
                       .arg(name == label ? name : name + " (" + label + ")")
                       .arg(object.revision)
                       .arg(object.views)
                       .arg(QString::fromStdString(word_of_verdict(object.quality.verdict)))
                       .arg(object.has_grasp ? ", with a grasp" : ""));
  return item;
}

void LibraryStrip::show_objects(const LibraryModel& library) {
  waiting_ = is_renaming() ? &library : nullptr;
  if (waiting_ != nullptr) return;
  const QString kept = wanted_.isEmpty() ? chosen() : wanted_;
  filling_ = true;
  list_->clear();
  for (const auto& object : library.objects()) {
    auto* item = make_item(object);
    list_->addItem(item);
    if (item->data(kNameRole) != kept) continue;
    list_->setCurrentItem(item);
    wanted_.clear();
  }
  filling_ = false;
  filter();
  undo_->setEnabled(library.can_undo());
  undo_->setToolTip(QString::fromStdString(library.undo_text()));
  show_choice();
}

void LibraryStrip::show_choice() {
  const bool any = !chosen().isEmpty();
  for (auto* button : {enable_, rename_, delete_}) button->setEnabled(any);
  for (auto* action : {export_, history_}) action->setEnabled(any);
  view_->setEnabled(any && teaching_allowed_);
  symmetry_->setEnabled(any);
  choose_symmetry(symmetry_, static_cast<std::uint8_t>(
                                 any ? list_->currentItem()->data(kSymmetryRole).toUInt() : 0));
  const bool enabled = !any || list_->currentItem()->data(kEnabledRole).toBool();
  relabel(enable_, enabled ? "&Disable" : "Ena&ble");
}

bool LibraryStrip::is_listed(const QString& name) const {
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->data(kNameRole) == name) return true;
  return false;
}

void LibraryStrip::take_new_name(QListWidgetItem* item) {
  if (filling_) return;
  const QString name = item->data(kNameRole).toString(), typed = item->text();
  if (typed == name) return complain("");
  filling_ = true;
  item->setText(name);  // shows the old name until the library confirms the new one
  filling_ = false;
  const TypedName tidy = usable_name(typed.toStdString());
  const QString wanted = QString::fromStdString(tidy.name);
  if (wanted.isEmpty())
    return complain(
        "Not renamed: a name begins with a letter and has only letters a to z, digits and _.");
  if (wanted != name && is_listed(wanted))
    return complain("Not renamed: '" + wanted + "' is in the library already. Give another name.");
  complain(QString::fromStdString(tidy.complaint));
  if (wanted != name)
    Q_EMIT edit_wanted(LibraryModel::rename(name.toStdString(), wanted.toStdString()));
}

void LibraryStrip::complain(const QString& sentence) {
  complaint_->setText(sentence);
  complaint_->setVisible(!sentence.isEmpty());
}

}  // namespace mbncc::console
