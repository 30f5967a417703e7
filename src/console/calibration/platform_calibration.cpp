// SPDX-License-Identifier: BSD-3-Clause
#include "console/calibration/platform_calibration.hpp"

#include <QDir>
#include <QRegularExpression>

namespace mbncc::console {
namespace {

/// Of a platform frame: a cell's frame is named after its namespace, so each has its own.
QString folder_of(const QString& frame) {
  const QString home = qEnvironmentVariable("ROS_HOME", QDir::homePath() + "/.ros");
  return home + "/mbncc_vision/" + frame;
}

QStringList lines_of(const QByteArray& output) {
  QStringList lines = QString::fromUtf8(output).split('\n');
  lines.removeAll("");
  return lines;
}

/// The lines about the pose, then how to use it; those in between name the files.
QString sentences_of(QStringList said) {
  const QString use = said.takeLast();
  const QStringList files = said.filter(QRegularExpression("^wrote "));
  for (const QString& file : files) said.removeAll(file);
  return "The " + said.join("; ") + ". To use it, " + use + ".";
}

}  // namespace

PlatformCalibration::PlatformCalibration(QObject* parent) : QObject(parent) {
  connect(&process_, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished), this,
          &PlatformCalibration::read_results);
  connect(&process_, &QProcess::errorOccurred, this, &PlatformCalibration::report_missing);
}

void PlatformCalibration::begin(const QStringList& arguments) {
  if (process_.state() != QProcess::NotRunning) return;
  const int frame = arguments.indexOf("--platform-frame") + 1;
  process_.start("rosrun", QStringList{"mbncc_vision", "calibrate_platform", "--out",
                                       folder_of(arguments.value(frame))} +
                               arguments);
}

void PlatformCalibration::read_results(int code, QProcess::ExitStatus status) {
  const QStringList said = lines_of(process_.readAllStandardOutput());
  const QStringList faults = lines_of(process_.readAllStandardError());
  if (status == QProcess::NormalExit && code == 0 && !said.isEmpty())
    Q_EMIT ended(true, sentences_of(said));
  else
    Q_EMIT ended(false, faults.isEmpty() ? "calibrate_platform ended without a reason"
                                         : faults.last().section(": ", 1));
}

void PlatformCalibration::report_missing(QProcess::ProcessError error) {
  if (error == QProcess::FailedToStart)
    Q_EMIT ended(false,
                 "rosrun was not found; start the console from a shell that has sourced ROS");
}

}  // namespace mbncc::console
