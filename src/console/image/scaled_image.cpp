// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/scaled_image.hpp"

#include <QPainter>

namespace mbncc::console {

QImage to_qimage(const cv::Mat& image) {
  if (image.empty()) return {};
  return QImage(image.data, image.cols, image.rows, static_cast<int>(image.step),
                QImage::Format_RGB888)
      .copy();
}

ScaledImage::ScaledImage(QSize least, QWidget* parent) : QWidget(parent) {
  setMinimumSize(least);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ScaledImage::show_image(const QImage& image) {
  if (image.isNull()) return;
  image_ = image;
  update();
}

void ScaledImage::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor("#303030"));
  if (image_.isNull()) return;
  QRect place(QPoint(), image_.size().scaled(size(), Qt::KeepAspectRatio));
  place.moveCenter(rect().center());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(place, image_);
}

}  // namespace mbncc::console
