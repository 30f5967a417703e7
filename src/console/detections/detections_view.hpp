// SPDX-License-Identifier: BSD-3-Clause
// The table of current detections.
#pragma once

#ifndef Q_MOC_RUN
#include <mbncc_vision/DetectedObjectArray.h>
#endif

#include <QTableWidget>

namespace mbncc::console {

class DetectionsView : public QTableWidget {
  Q_OBJECT

 public:
  explicit DetectionsView(QWidget* parent = nullptr);

  void show_detections(const mbncc_vision::DetectedObjectArray& detections, double age);
  /// Clears the list.
  void clear_rows() { setRowCount(0); }
};

}  // namespace mbncc::console
