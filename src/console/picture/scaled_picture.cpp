// SPDX-License-Identifier: BSD-3-Clause
#include "console/picture/scaled_picture.hpp"

#include <QPainter>

namespace mbncc::console {

ScaledPicture::ScaledPicture(QSize least, QWidget* parent) : QWidget(parent) {
  setMinimumSize(least);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ScaledPicture::show_picture(const QImage& picture) {
  if (picture.isNull()) return;
  picture_ = picture;
  update();
}

void ScaledPicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor("#303030"));
  if (picture_.isNull()) return;
  QRect place(QPoint(), picture_.size().scaled(size(), Qt::KeepAspectRatio));
  place.moveCenter(rect().center());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(place, picture_);
}

}  // namespace mbncc::console
