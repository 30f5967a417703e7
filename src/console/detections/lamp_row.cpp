// SPDX-License-Identifier: BSD-3-Clause
#include "console/detections/lamp_row.hpp"

#include <QHBoxLayout>

#include "console/widgets.hpp"

namespace mbncc::console {

LampRow::LampRow(QWidget* parent) : QWidget(parent), reasons_(new QLabel) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  for (auto*& label : labels_) {
    label = new QLabel;
    row->addWidget(label);
  }
  row->addWidget(reasons_, 1);
  reasons_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void LampRow::show_lamps(const std::array<Lamp, 4>& lamps) {
  QStringList reasons;
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    const QString reason = QString::fromStdString(lamps[i].reason);
    show_level(labels_[i], lamps[i].level, lamps[i].name);
    labels_[i]->setToolTip(reason.isEmpty() ? "all is well" : reason);
    if (!reason.isEmpty()) reasons << QString(lamps[i].name) + ": " + reason;
  }
  // Always one line, so that widgets below do not move.
  const QString all =
      reasons.isEmpty() ? "Camera, calibration, library and matcher are OK." : reasons.join("; ");
  reasons_->setText(reasons_->fontMetrics().elidedText(all, Qt::ElideRight, reasons_->width() - 4));
  reasons_->setToolTip(reasons.join("\n"));
}

}  // namespace mbncc::console
