// SPDX-License-Identifier: BSD-3-Clause
// The buttons below the image: marks and zoom, search region, camera, thresholds, and why something
// was not found.
#pragma once

#include <QPushButton>
#include <QWidget>

namespace mbncc::console {

class ImageBar : public QWidget {
  Q_OBJECT

 public:
  explicit ImageBar(QWidget* parent = nullptr);

  /// Enables what needs the cell without a lesson (`cell`), and the camera's calibration.
  void allow(bool cell, bool camera);
  /// Labels the region's button by what it does next. `limited`: only a region is searched.
  void show_region(bool limited);

  // These act as the buttons do, and only while they are enabled.
  void press_marks() { marks_->click(); }
  void press_region() { region_->click(); }
  void press_camera() { camera_->click(); }

 Q_SIGNALS:
  void marks_hidden(bool hidden);
  void all_wanted();
  void region_wanted();
  void camera_wanted();
  void thresholds_wanted();
  void explanation_wanted();

 private:
  QPushButton *marks_, *all_, *region_, *camera_, *thresholds_, *why_;
};

}  // namespace mbncc::console
