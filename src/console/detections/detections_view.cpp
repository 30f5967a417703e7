// SPDX-License-Identifier: BSD-3-Clause
#include "console/detections/detections_view.hpp"

#include <QHeaderView>

#include "console/detections/detection_rows.hpp"

namespace mbncc::console {
namespace {

void paint_state(QTableWidgetItem& cell, Level level) {
  cell.setBackground(QColor(colour_of(level)));
  cell.setForeground(QColor(ink_on(level)));
}

}  // namespace

DetectionsView::DetectionsView(QWidget* parent) : QTableWidget(parent) {
  const auto& headings = detection_headings();
  setColumnCount(static_cast<int>(headings.size()));
  QStringList labels;
  for (const char* heading : headings) labels << heading;
  setHorizontalHeaderLabels(labels);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().lineSpacing() + 8);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setTextElideMode(Qt::ElideMiddle);
  setEditTriggers(NoEditTriggers);
  setSelectionMode(NoSelection);
  setFocusPolicy(Qt::NoFocus);
  // The last column, the age, is hidden because the age is shown with the image.
  setColumnHidden(columnCount() - 1, true);
}

void DetectionsView::show_detections(const mbncc_vision::DetectedObjectArray& detections,
                                     double age) {
  const auto rows = detection_rows(detections, age);
  setRowCount(static_cast<int>(rows.size()));
  for (int row = 0; row < rowCount(); ++row) {
    for (int column = 0; column < columnCount(); ++column) {
      if (item(row, column) == nullptr) setItem(row, column, new QTableWidgetItem);
      item(row, column)->setText(QString::fromStdString(rows[row].cells[column]));
      item(row, column)->setToolTip(QString::fromStdString(rows[row].reasons));
    }
    paint_state(*item(row, 1), rows[row].level);
  }
}

}  // namespace mbncc::console
