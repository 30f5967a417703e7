// SPDX-License-Identifier: BSD-3-Clause
// An image as large as its room allows, on a dark ground.
#pragma once

#include <QImage>
#include <QSize>
#include <QWidget>

namespace mbncc::console {

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
