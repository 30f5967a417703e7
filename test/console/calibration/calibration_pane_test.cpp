// SPDX-License-Identifier: BSD-3-Clause
#include "console/calibration/calibration_pane.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>
#include <QThread>

#include "console/calibration/drawn_board.hpp"

namespace mbncc::console {
namespace {

QPushButton* button(const QWidget& pane, const QString& name) {
  return pane.findChild<QPushButton*>(name);
}

TEST(CalibrationPane, ABoardThatWasNeverTiltedCannotBeKept) {
  CalibrationPane pane;
  pane.begin();
  for (const double x : {-0.2, -0.1, 0.}) {
    const cv::Mat image = board_at({0, 0, 0}, {x, -0.06, 0.6}, Board());
    pane.take(QImage(image.data, image.cols, image.rows, static_cast<int>(image.step),
                     QImage::Format_RGB888),
              {kImage.width, kImage.height});
    QThread::msleep(410);  // it looks at few images per second
  }
  ASSERT_TRUE(button(pane, "Compute")->isEnabled());
  button(pane, "Compute")->click();
  EXPECT_FALSE(button(pane, "Keep")->isEnabled());
}

/// While it exists, rosrun only prints its arguments.
class PrintingRosrun {
 public:
  PrintingRosrun() {
    QFile program(folder_.filePath("rosrun"));
    program.open(QIODevice::WriteOnly);
    program.write("#!/bin/sh\necho \"$@\"\necho start the cell\n");
    program.setPermissions(QFile::ReadOwner | QFile::ExeOwner);
    qputenv("PATH", folder_.path().toLocal8Bit() + ":" + path_);
  }
  ~PrintingRosrun() { qputenv("PATH", path_); }

 private:
  QTemporaryDir folder_;
  const QByteArray path_ = qgetenv("PATH");
};

QString texts(const QWidget& pane) {
  QString text;
  for (const auto* label : pane.findChildren<QLabel*>()) text += label->text() + "\n";
  return text;
}

TEST(CalibrationPane, ThePlatformIsCalibratedBelowTheBoardsThickness) {
  const PrintingRosrun rosrun;
  CalibrationPane pane;
  pane.findChild<QDoubleSpinBox*>("thickness")->setValue(5);
  pane.calibrate_platform({"/", "/image_raw"});
  while (!button(pane, "Platform")->isEnabled())
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  EXPECT_TRUE(texts(pane).contains("--thickness 0.005 ")) << texts(pane).toStdString();
}

TEST(CalibrationPane, ANewLensCalibrationNeedsANewOneOfThePlatform) {
  CalibrationPane pane;
  pane.show_kept(true, "");
  EXPECT_TRUE(texts(pane).contains("The platform's pose still rests on the old calibration"))
      << texts(pane).toStdString();
}

}  // namespace
}  // namespace mbncc::console
