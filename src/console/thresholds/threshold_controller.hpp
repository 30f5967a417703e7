// SPDX-License-Identifier: BSD-3-Clause
// Other thresholds tried on one picture of the cell, and applied.
#pragma once

#ifndef Q_MOC_RUN
#include "console/ros_link.hpp"
#include "console/thresholds/threshold_preview.hpp"
#endif

#include <QImage>
#include <QObject>
#include <QSize>

namespace mbncc::console {

class PictureView;
class ThresholdPane;

class ThresholdController : public QObject {
  Q_OBJECT

 public:
  /// `ros`, `pane` and `picture` outlive it.
  ThresholdController(RosLink& ros, ThresholdPane& pane, PictureView& picture, QObject* parent);

  /// Asks the matcher for all it finds in the picture shown; found() follows, or told().
  void ask();
  /// Shows what was found; `object`: the one whose min_score may be set alone, "": none.
  void begin(const QString& object);

 Q_SIGNALS:
  void found();
  void applied();
  void told(bool success, QString sentence);

 private:
  void show();
  void apply(const QString& object);

  RosLink& ros_;
  ThresholdPane& pane_;
  PictureView& view_;
  ThresholdPreview preview_;
  QImage picture_;
  QSize size_;
};

}  // namespace mbncc::console
