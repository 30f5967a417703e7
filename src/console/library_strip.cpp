#include "console/library_strip.hpp"

#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

#include "console/pictures.hpp"
#include "console/ros_link.hpp"
#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

constexpr int kNameRole = Qt::UserRole, kEnabledRole = Qt::UserRole + 1,
              kSymmetryRole = Qt::UserRole + 2;
constexpr QSize kIcon(72, 72);

QPixmap icon_of(const mbncc_vision::LearnedObject& object) {
  QPixmap icon(kIcon);
  icon.fill(QColor("#303030"));
  const QImage picture = to_qimage(to_rgb(object.thumbnail));
  QPainter painter(&icon);
  if (!picture.isNull()) {
    const QImage scaled = picture.scaled(kIcon, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    painter.setOpacity(object.enabled ? 1 : 0.3);
    painter.drawImage((kIcon.width() - scaled.width()) / 2, (kIcon.height() - scaled.height()) / 2,
                      scaled);
    painter.setOpacity(1);
  }
  // The verdict's lamp in the corner.
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
      list_(new QListWidget),
      symmetry_(make_symmetry_box("At which angles the chosen object counts as the same")),
      enable_(make_button("&Disable", "Search for the chosen object, or not", this)),
      rename_(make_button("Re&name", "Write a new name below its picture", this)),
      delete_(make_button("De&lete", "Take it out of the library; Undo brings it back", this)),
      undo_(make_button("Undo &edit", "Take the last change of the library back", this)) {
  list_->setViewMode(QListView::IconMode);
  list_->setFlow(QListView::LeftToRight);
  list_->setWrapping(false);
  list_->setMovement(QListView::Static);
  list_->setIconSize(kIcon);
  list_->setFixedHeight(kIcon.height() + 44);
  list_->setTextElideMode(Qt::ElideMiddle);
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  name_window(list_, "library");

  auto* row = new QHBoxLayout;
  for (auto* button : {enable_, rename_, delete_}) row->addWidget(button);
  row->addWidget(symmetry_);
  row->addWidget(undo_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(list_);
  all->addLayout(row);

  connect(list_, &QListWidget::itemSelectionChanged, this, &LibraryStrip::show_choice);
  connect(list_, &QListWidget::itemChanged, this, &LibraryStrip::take_new_name);
  connect(enable_, &QPushButton::clicked, [this] {
    const bool enabled = list_->currentItem()->data(kEnabledRole).toBool();
    Q_EMIT edit_wanted(LibraryModel::enable(chosen().toStdString(), !enabled));
  });
  connect(rename_, &QPushButton::clicked, [this] { list_->editItem(list_->currentItem()); });
  connect(delete_, &QPushButton::clicked,
          [this] { Q_EMIT edit_wanted(LibraryModel::remove(chosen().toStdString())); });
  connect(undo_, &QPushButton::clicked, this, &LibraryStrip::undo_wanted);
  // Of the operator alone, not of show_choice().
  connect(symmetry_, QOverload<int>::of(&QComboBox::activated), [this] {
    const auto known = list_->currentItem()->data(kSymmetryRole).toUInt();
    if (chosen_symmetry(symmetry_) != known)
      Q_EMIT symmetry_wanted(chosen(), chosen_symmetry(symmetry_));
  });
  show_choice();
  undo_->setEnabled(false);
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
  item->setSizeHint({kIcon.width() + 28, kIcon.height() + 24});  // long names are cut
  item->setToolTip(QString("%1, revision %2, verdict %3%4")
                       .arg(name == label ? name : name + " (" + label + ")")
                       .arg(object.revision)
                       .arg(QString::fromStdString(word_of_verdict(object.quality.verdict)))
                       .arg(object.has_grasp ? ", with a grasp" : ""));
  return item;
}

void LibraryStrip::show_objects(const LibraryModel& library) {
  const QString kept = chosen();
  filling_ = true;
  list_->clear();
  for (const auto& object : library.objects()) {
    auto* item = make_item(object);
    list_->addItem(item);
    if (item->data(kNameRole) == kept) list_->setCurrentItem(item);
  }
  filling_ = false;
  undo_->setEnabled(library.can_undo());
  undo_->setToolTip(QString::fromStdString(library.undo_text()));
  show_choice();
}

void LibraryStrip::show_choice() {
  const bool any = !chosen().isEmpty();
  for (auto* button : {enable_, rename_, delete_}) button->setEnabled(any);
  symmetry_->setEnabled(any);
  choose_symmetry(symmetry_, static_cast<std::uint8_t>(
                                 any ? list_->currentItem()->data(kSymmetryRole).toUInt() : 0));
  const bool enabled = !any || list_->currentItem()->data(kEnabledRole).toBool();
  enable_->setText(enabled ? "&Disable" : "Ena&ble");
}

void LibraryStrip::take_new_name(QListWidgetItem* item) {
  if (filling_) return;
  const QString name = item->data(kNameRole).toString(), wanted = item->text();
  if (wanted == name) return;
  filling_ = true;
  item->setText(name);  // until the library says otherwise
  filling_ = false;
  Q_EMIT edit_wanted(LibraryModel::rename(name.toStdString(), wanted.toStdString()));
}

}  // namespace mbncc::console
