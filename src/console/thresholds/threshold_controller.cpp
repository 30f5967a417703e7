// SPDX-License-Identifier: BSD-3-Clause
#include "console/thresholds/threshold_controller.hpp"

#include "console/picture/picture_view.hpp"
#include "console/thresholds/threshold_pane.hpp"

namespace mbncc::console {

ThresholdController::ThresholdController(RosLink& ros, ThresholdPane& pane, PictureView& picture,
                                         QObject* parent)
    : QObject(parent), ros_(ros), pane_(pane), view_(picture) {
  connect(&ros, &RosLink::all_found, this,
          [this](bool success, const QString& message, const QImage& image, QSize size,
                 const mbncc_vision::DetectedObjectArray& detections) {
            if (!success) {
              Q_EMIT told(false, "Thresholds: " + message);
              return;
            }
            preview_ = ThresholdPreview(detections, ros_.thresholds());
            picture_ = image;
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

void ThresholdController::begin(const QString& object) {
  pane_.begin(preview_.now(), object);
  show();
}

void ThresholdController::show() {
  const Thresholds wanted = pane_.wanted();
  pane_.show_summary(QString::fromStdString(preview_.summary(wanted)));
  view_.show_picture(picture_, size_, preview_.marks(wanted), "One picture");
}

void ThresholdController::apply(const QString& object) {
  if (object.isEmpty()) {
    ros_.set_thresholds(pane_.wanted());
  } else {
    mbncc_vision::EditObject::Request request;
    request.name = object.toStdString();
    request.command = mbncc_vision::EditObject::Request::SET_THRESHOLD;
    request.min_score = static_cast<float>(pane_.wanted().min_score);
    ros_.edit(request);
  }
  Q_EMIT applied();
}

}  // namespace mbncc::console
