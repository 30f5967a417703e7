// SPDX-License-Identifier: BSD-3-Clause
#include "console/calibration/coverage_view.hpp"

#include <QPainter>

#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

const QColor kGround("#303030"), kCovered("#0072b2"), kGrid("#808080"), kBoard("#f0e442");
constexpr int kFields = BoardCalibration::kFields;

}  // namespace

CoverageView::CoverageView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(160, 120);
  setToolTip("Ticked fields of the image were covered by a board; outlines are the boards");
  name_window(this, "coverage");
}

void CoverageView::show_coverage(const BoardCalibration& calibration) {
  image_ = calibration.size();
  fields_ = calibration.fields();
  boards_ = calibration.outlines();
  setAccessibleDescription(QString("%1 of %2 fields, %3 boards")
                               .arg(fields_.size())
                               .arg(kFields * kFields)
                               .arg(boards_.size()));
  update();
}

/// The rectangle that shows the whole image, as large as the widget allows.
QRectF CoverageView::plan() const {
  QSizeF shape(image_.width, image_.height);
  shape.scale(size(), Qt::KeepAspectRatio);
  return {QPointF((width() - shape.width()) / 2, 0), shape};
}

void CoverageView::paintEvent(QPaintEvent*) {
  if (image_.empty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF plan = this->plan();
  const QSizeF cell = plan.size() / kFields;
  for (int field = 0; field < kFields * kFields; ++field) {
    const QRectF box(
        plan.topLeft() + QPointF(field % kFields * cell.width(), field / kFields * cell.height()),
        cell);
    const bool covered = fields_.count(field) != 0;
    painter.setPen(kGrid);
    painter.setBrush(covered ? kCovered : kGround);
    painter.drawRect(box);
    painter.setPen(Qt::white);
    // Covered fields are not shown by colour alone.
    if (covered) painter.drawText(box, Qt::AlignCenter, QString::fromUtf8("\u2714"));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kBoard, 1));
  for (const auto& board : boards_) {
    QPolygonF outline;
    for (const auto& corner : board)
      outline << plan.topLeft() +
                     QPointF(double(corner.x), double(corner.y)) * plan.width() / image_.width;
    painter.drawPolygon(outline);
  }
}

}  // namespace mbncc::console
