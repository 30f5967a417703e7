// SPDX-License-Identifier: BSD-3-Clause
#include "console/calibration/platform_calibration.hpp"

#include <QDir>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

namespace mbncc::console {
namespace {

/// Name of the platform's frame. Each cell has its own, named after its namespace.
std::string frame_of(const std::string& cell) {
  std::string name = cell.substr(1);
  std::replace(name.begin(), name.end(), '/', '_');
  return name.empty() ? "platform" : name + "_platform";
}

QString folder_of(const std::string& frame) {
  const QString home = qEnvironmentVariable("ROS_HOME", QDir::homePath() + "/.ros");
  return home + "/mbncc_vision/" + QString::fromStdString(frame);
}

/// Arguments of calibrate_platform; camera_info is in the namespace of the images.
QStringList arguments_of(const Board& board, double thickness, const CellImages& images) {
  const std::string frame = frame_of(images.cell);
  const auto last = images.topic.rfind('/') + 1;
  const std::string info = images.topic.substr(0, last) + "camera_info";
  QStringList arguments{"--chessboard",
                        QString("%1x%2").arg(board.columns).arg(board.rows),
                        "--square",
                        QString::number(board.square, 'g', 6),
                        "--thickness",
                        QString::number(thickness, 'g', 6),
                        "--out",
                        folder_of(frame),
                        "--platform-frame",
                        QString::fromStdString(frame),
                        QString::fromStdString("image_raw:=" + images.topic),
                        QString::fromStdString("camera_info:=" + info)};
  if (images.topic.compare(last, 10, "image_rect") == 0) arguments += "--rectified";
  if (images.white_level > 0) arguments += {"--white-level", QString::number(images.white_level)};
  return arguments;
}

QStringList lines_of(const QByteArray& output) {
  QStringList lines = QString::fromUtf8(output).split('\n');
  lines.removeAll("");
  return lines;
}

/// The first lines of the output describe the pose, the last one how to use it; those in between
/// name the files.
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

void PlatformCalibration::begin(const Board& board, double thickness, const CellImages& images) {
  if (process_.state() != QProcess::NotRunning) return;
  process_.start("rosrun", QStringList{"mbncc_vision", "calibrate_platform"} +
                               arguments_of(board, thickness, images));
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
