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
  // Always two lines, so that nothing below moves under the mouse.
  reasons_->setWordWrap(true);
  reasons_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  reasons_->setFixedHeight(2 * reasons_->fontMetrics().lineSpacing() + 4);
}

void LampRow::show_lamps(const std::array<Lamp, 4>& lamps) {
  QStringList reasons;
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    const QString reason = QString::fromStdString(lamps[i].reason);
    show_level(labels_[i], lamps[i].level, lamps[i].name);
    labels_[i]->setToolTip(reason.isEmpty() ? "all is well" : reason);
    if (!reason.isEmpty()) reasons << QString(lamps[i].name) + ": " + reason;
  }
  const QString all =
      reasons.isEmpty() ? "Camera, calibration, library and matcher are OK." : reasons.join("; ");
  // A line is not filled completely, because words wrap.
  constexpr double kFilled = 1.8;
  const int room = static_cast<int>(kFilled * reasons_->width());
  reasons_->setText(reasons_->fontMetrics().elidedText(all, Qt::ElideRight, room));
  reasons_->setToolTip(reasons.join("\n"));
}

}  // namespace mbncc::console
