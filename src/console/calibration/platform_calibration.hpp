// SPDX-License-Identifier: BSD-3-Clause
// Runs calibrate_platform on the cell's live images.
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>

#include <string>

#ifndef Q_MOC_RUN
#include "console/calibration/board_calibration.hpp"
#include "console/cell_settings.hpp"
#endif

namespace mbncc::console {

class PlatformCalibration : public QObject {
  Q_OBJECT

 public:
  explicit PlatformCalibration(QObject* parent = nullptr);

  /// Calibrates from the board that lies on the cell's platform; `thickness` [m] is the height of
  /// its printed face above the platform. The files go to ROS_HOME (~/.ros) on this computer and
  /// replace those of an earlier calibration of the cell. Ignored while a calibration is running.
  void begin(const Board& board, double thickness, const CellImages& images);

 Q_SIGNALS:
  /// `message`: the pose and how to start the cell with it, or why the calibration failed.
  void ended(bool success, QString message);

 private:
  void read_results(int code, QProcess::ExitStatus status);
  void report_missing(QProcess::ProcessError error);

  QProcess process_;
};

}  // namespace mbncc::console
