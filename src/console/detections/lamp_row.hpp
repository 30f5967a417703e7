// SPDX-License-Identifier: BSD-3-Clause
// The cell's status lamps, and the reasons of those that report a fault.
#pragma once

#ifndef Q_MOC_RUN
#include "console/detections/lamps.hpp"
#endif

#include <QLabel>
#include <QWidget>
#include <array>

namespace mbncc::console {

class LampRow : public QWidget {
  Q_OBJECT

 public:
  explicit LampRow(QWidget* parent = nullptr);

  void show_lamps(const std::array<Lamp, 4>& lamps);

 private:
  std::array<QLabel*, 4> labels_;
  QLabel* reasons_;
};

}  // namespace mbncc::console
