// SPDX-License-Identifier: BSD-3-Clause
// A plan of the image with the boards recorded so far and the fields that they cover.
#pragma once

#ifndef Q_MOC_RUN
#include "console/calibration/board_calibration.hpp"
#endif

#include <QWidget>
#include <set>
#include <vector>

namespace mbncc::console {

class CoverageView : public QWidget {
  Q_OBJECT

 public:
  explicit CoverageView(QWidget* parent = nullptr);

  void show_coverage(const BoardCalibration& calibration);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRectF plan() const;

  cv::Size image_;
  std::set<int> fields_;
  std::vector<std::vector<cv::Point2f>> boards_;
};

}  // namespace mbncc::console
