// SPDX-License-Identifier: BSD-3-Clause
// A picture as large as its room allows, on a dark ground.
#pragma once

#include <QImage>
#include <QSize>
#include <QWidget>

namespace mbncc::console {

class ScaledPicture : public QWidget {
  Q_OBJECT

 public:
  explicit ScaledPicture(QSize least, QWidget* parent = nullptr);

  /// A null picture changes nothing.
  void show_picture(const QImage& picture);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage picture_;
};

}  // namespace mbncc::console
