// SPDX-License-Identifier: BSD-3-Clause
// Runs calibrate_platform on the cell's live images.
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>

namespace mbncc::console {

class PlatformCalibration : public QObject {
  Q_OBJECT

 public:
  explicit PlatformCalibration(QObject* parent = nullptr);

  /// `arguments` of calibrate_platform without --out: the files go to ROS_HOME (~/.ros) of this
  /// computer, where those of an earlier calibration of this platform are replaced. Ignored while
  /// one runs.
  void begin(const QStringList& arguments);

 Q_SIGNALS:
  /// `message`: the pose and how to start the cell with it, or why there is none.
  void ended(bool success, QString message);

 private:
  void read_results(int code, QProcess::ExitStatus status);
  void report_missing(QProcess::ProcessError error);

  QProcess process_;
};

}  // namespace mbncc::console
