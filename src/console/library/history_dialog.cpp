// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/history_dialog.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "console/ros_link.hpp"
#include "console/widgets.hpp"

namespace mbncc::console {

HistoryDialog::HistoryDialog(const QString& name, const std::vector<Revision>& revisions,
                             QWidget* parent)
    : QDialog(parent), list_(new QListWidget) {
  setWindowTitle("Earlier revisions of " + name);
  setAttribute(Qt::WA_DeleteOnClose);
  list_->setIconSize({96, 96});
  for (const auto& revision : revisions) {
    auto* item = new QListWidgetItem(QIcon(QPixmap::fromImage(to_qimage(revision.picture))),
                                     QString::fromStdString(revision.text));
    item->setData(Qt::UserRole, revision.number);
    list_->addItem(item);
  }
  auto* restore = make_button("&Restore", "The present one goes to the trash", "Alt+R");
  auto* close = make_button("&Close", "Change nothing", "Esc");
  restore->setEnabled(!revisions.empty());
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  row->addWidget(restore);
  row->addWidget(close);
  auto* all = new QVBoxLayout(this);
  all->addWidget(new QLabel(revisions.empty() ? "There are none yet: a revision is kept whenever "
                                                "the object is taught again or its frame is moved."
                                              : "The newest is on top."));
  all->addWidget(list_, 1);
  all->addLayout(row);
  resize(480, 400);
  list_->setCurrentRow(0);
  connect(restore, &QPushButton::clicked, this, [this] {
    if (list_->currentItem() != nullptr)
      Q_EMIT revision_wanted(list_->currentItem()->data(Qt::UserRole).toInt());
    accept();
  });
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
}

}  // namespace mbncc::console
