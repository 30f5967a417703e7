// SPDX-License-Identifier: BSD-3-Clause
#include "console/calibration/calibration_pane.hpp"

#include <gtest/gtest.h>

#include <QPushButton>
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

}  // namespace
}  // namespace mbncc::console
