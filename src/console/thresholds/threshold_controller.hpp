// SPDX-License-Identifier: BSD-3-Clause
// Tries other thresholds on one image of the cell, and applies them.
#pragma once

#ifndef Q_MOC_RUN
#include "console/library/library_model.hpp"
#include "console/ros_link.hpp"
#include "console/thresholds/threshold_preview.hpp"
#endif

#include <QImage>
#include <QObject>
#include <QSize>

namespace mbncc::console {

class ImageView;
class ThresholdPane;

class ThresholdController : public QObject {
  Q_OBJECT

 public:
  /// `ros`, `pane` and `image` must outlive it.
  ThresholdController(RosLink& ros, ThresholdPane& pane, ImageView& image, QObject* parent);

  /// Asks the matcher for everything it finds in the image shown; found() or told() follows.
  void ask();
  /// Shows the detections. `object`: the one whose min_score may be set separately; "": none. The
  /// objects' own thresholds are taken from `library`.
  void begin(const QString& object, const LibraryModel& library);

 Q_SIGNALS:
  void found();
  void applied();
  /// The object's own min_score; 0 removes it.
  void own_wanted(QString object, double min_score);
  void told(bool success, QString sentence);

 private:
  void show();
  void apply();

  RosLink& ros_;
  ThresholdPane& pane_;
  ImageView& view_;
  ThresholdPreview preview_;
  mbncc_vision::DetectedObjectArray found_;
  QImage image_;
  QSize size_;
  QString caption_;
};

}  // namespace mbncc::console
