// SPDX-License-Identifier: BSD-3-Clause
// Focus, exposure and calibration of the camera and of the platform from live images.
#pragma once

#ifndef Q_MOC_RUN
#include "console/calibration/board_calibration.hpp"
#include "console/calibration/image_check.hpp"
#include "console/calibration/platform_calibration.hpp"
#include "console/image/marks.hpp"
#endif

#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QWidget>

namespace mbncc::console {

class CoverageView;

class CalibrationPane : public QWidget {
  Q_OBJECT

 public:
  explicit CalibrationPane(QWidget* parent = nullptr);

  void begin();
  /// `size` [px] of the camera's image; returns the marks to draw over it.
  std::vector<Mark> take(const QImage& image, QSize size);
  void show_kept(bool success, const QString& message);
  /// Starts the platform's calibration with the board that lies on the platform.
  void calibrate_platform(const CellImages& images);

 Q_SIGNALS:
  void keep_wanted(sensor_msgs::CameraInfo calibration);
  void platform_wanted();
  void closed();

 private:
  Board board() const;
  void start_over();
  void compute();
  void show_platform(bool success, const QString& message);

  ImageCheck check_;
  BoardCalibration calibration_;
  BoardCalibration::Result result_;
  PlatformCalibration platform_calibration_;
  QSize size_;
  std::vector<Mark> marks_;
  QElapsedTimer since_look_;
  QSpinBox *columns_, *rows_;
  QDoubleSpinBox *square_, *thickness_;
  CoverageView* coverage_;
  QLabel *image_text_, *board_text_, *result_text_;
  QPushButton *compute_, *keep_, *start_over_, *platform_;
};

}  // namespace mbncc::console
