#include "console/detections_view.hpp"

#include <QHeaderView>

#include "console/detection_rows.hpp"

namespace mbncc::console {

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
  setEditTriggers(NoEditTriggers);
  setSelectionMode(NoSelection);
  setFocusPolicy(Qt::NoFocus);
}

void DetectionsView::show_detections(const mbncc_vision::DetectedObjectArray& detections,
                                     double age) {
  const auto rows = detection_rows(detections, age);
  setRowCount(static_cast<int>(rows.size()));
  for (int row = 0; row < rowCount(); ++row)
    for (int column = 0; column < columnCount(); ++column) {
      if (item(row, column) == nullptr) setItem(row, column, new QTableWidgetItem);
      item(row, column)->setText(QString::fromStdString(rows[row].cells[column]));
      item(row, column)
          ->setForeground(column == 1 ? QBrush(QColor(colour_of(rows[row].level)))
                                      : QBrush(Qt::black));
    }
}

}  // namespace mbncc::console
