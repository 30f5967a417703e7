// SPDX-License-Identifier: BSD-3-Clause
#include "console/thresholds/threshold_controller.hpp"

#include "console/image/image_view.hpp"
#include "console/thresholds/threshold_pane.hpp"

namespace mbncc::console {

ThresholdController::ThresholdController(RosLink& ros, ThresholdPane& pane, ImageView& image,
                                         QObject* parent)
    : QObject(parent), ros_(ros), pane_(pane), view_(image) {
  connect(&ros, &RosLink::all_found, this,
          [this](bool success, const QString& message, const QImage& image, QSize size,
                 const mbncc_vision::DetectedObjectArray& detections) {
            if (!success) {
              Q_EMIT told(false, "Thresholds: " + message);
              return;
            }
            found_ = detections;
            caption_ = still_caption();
            image_ = image;
            size_ = size;
            Q_EMIT found();
          });
  connect(&ros, &RosLink::thresholds_set, this, &ThresholdController::told);
  connect(&pane, &ThresholdPane::moved, this, &ThresholdController::show);
  connect(&pane, &ThresholdPane::apply_wanted, this, &ThresholdController::apply);
}

void ThresholdController::ask() {
  ros_.find_all();
}

void ThresholdController::begin(const QString& object, const LibraryModel& library) {
  Thresholds now = ros_.thresholds();
  for (const auto& known : library.objects())
    if (known.min_score > 0) now.own[known.name] = static_cast<double>(known.min_score);
  preview_ = ThresholdPreview(found_, now);
  pane_.begin(now, object);
  show();
}

void ThresholdController::show() {
  const Thresholds wanted = pane_.wanted();
  pane_.show_summary(
      QString::fromStdString(preview_.summary(wanted, pane_.object().toStdString())));
  view_.show_image(image_, size_, preview_.marks(wanted), caption_);
}

void ThresholdController::apply() {
  const std::string object = pane_.object().toStdString();
  const Thresholds wanted = pane_.wanted();
  if (object.empty())
    ros_.set_thresholds(wanted);
  else
    Q_EMIT own_wanted(pane_.object(), wanted.own.count(object) ? wanted.own.at(object) : 0);
  Q_EMIT applied();
}

}  // namespace mbncc::console
