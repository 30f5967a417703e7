// SPDX-License-Identifier: BSD-3-Clause
// A widget with an image as large as its space allows, on a dark background.
#pragma once

#include <QImage>
#include <QSize>
#include <QWidget>
#include <opencv2/core.hpp>

namespace mbncc::console {

/// A copy of `image` (CV_8UC3 rgb); null if `image` is empty.
QImage to_qimage(const cv::Mat& image);

class ScaledImage : public QWidget {
  Q_OBJECT

 public:
  explicit ScaledImage(QSize least, QWidget* parent = nullptr);

  /// Ignores a null image.
  void show_image(const QImage& image);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage image_;
};

}  // namespace mbncc::console
