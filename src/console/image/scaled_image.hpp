// SPDX-License-Identifier: BSD-3-Clause
// An image as large as its room allows, on a dark ground.
#pragma once

#include <QImage>
#include <QSize>
#include <QWidget>
#include <opencv2/core.hpp>

namespace mbncc::console {

/// A copy of `image`, CV_8UC3 rgb; null if it is empty.
QImage to_qimage(const cv::Mat& image);

class ScaledImage : public QWidget {
  Q_OBJECT

 public:
  explicit ScaledImage(QSize least, QWidget* parent = nullptr);

  /// A null image changes nothing.
  void show_image(const QImage& image);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage image_;
};

}  // namespace mbncc::console
