// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/trash_dialog.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "console/image/scaled_image.hpp"
#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

constexpr int kNameRole = Qt::UserRole, kNumberRole = Qt::UserRole + 1;
constexpr QSize kSize(700, 440);  // wide enough for the longest name

}  // namespace

TrashDialog::TrashDialog(const QString& title, const QString& text, QWidget* parent)
    : QDialog(parent),
      list_(new QListWidget),
      restore_(make_button("&Restore", "Undo edit reverts it", "Alt+R")) {
  setWindowTitle(title);
  setAttribute(Qt::WA_DeleteOnClose);
  list_->setIconSize({96, 96});
  list_->setWordWrap(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  name_window(list_, "trash");
  auto* close = make_button("&Close", "Change nothing", "Esc");
  restore_->setEnabled(false);
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  row->addWidget(restore_);
  row->addWidget(close);
  auto* words = new QLabel(text);
  words->setWordWrap(true);
  auto* all = new QVBoxLayout(this);
  all->addWidget(words);
  all->addWidget(list_, 1);
  all->addLayout(row);
  resize(kSize);
  connect(restore_, &QPushButton::clicked, this, &TrashDialog::restore);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
}

void TrashDialog::add(const Revision& revision, const QString& label) {
  auto* item = new QListWidgetItem(QIcon(QPixmap::fromImage(to_qimage(revision.image))), label);
  item->setData(kNameRole, QString::fromStdString(revision.name));
  item->setData(kNumberRole, revision.number);
  item->setToolTip(label);
  list_->addItem(item);
  if (list_->count() == 1) list_->setCurrentRow(0);
  restore_->setEnabled(true);
}

void TrashDialog::restore() {
  if (const auto* item = list_->currentItem())
    Q_EMIT restore_wanted(item->data(kNameRole).toString(), item->data(kNumberRole).toUInt());
  accept();
}

}  // namespace mbncc::console
