// SPDX-License-Identifier: BSD-3-Clause
#include "console/picture/picture_frame.hpp"

#include <algorithm>

namespace mbncc::console {
namespace {

constexpr double kLargestZoom = 12;

}  // namespace

void PictureFrame::set_sizes(cv::Size picture, cv::Size widget) {
  if (picture.empty() || widget.empty()) return;
  if (picture != picture_) zoom_ = 1;
  picture_ = picture;
  widget_ = widget;
  fit_ = std::min(static_cast<double>(widget.width) / picture.width,
                  static_cast<double>(widget.height) / picture.height);
  stay_inside();
}

cv::Point2d PictureFrame::corner() const {
  const cv::Point2d centre =
      zoom_ > 1 ? centre_ : cv::Point2d(picture_.width / 2.0, picture_.height / 2.0);
  return cv::Point2d(widget_.width / 2.0, widget_.height / 2.0) - centre * scale();
}

// Pixel centres are at integers, so the picture's corner is at -0.5.
cv::Point2d PictureFrame::to_picture(cv::Point2d widget) const {
  return (widget - corner()) / scale() - cv::Point2d(0.5, 0.5);
}

cv::Point2d PictureFrame::to_widget(cv::Point2d picture) const {
  return (picture + cv::Point2d(0.5, 0.5)) * scale() + corner();
}

void PictureFrame::zoom(double factor, cv::Point2d about) {
  const cv::Point2d kept = to_picture(about);
  zoom_ = std::clamp(zoom_ * factor, 1.0, kLargestZoom);
  // The point under the mouse stays there.
  const cv::Point2d middle(widget_.width / 2.0, widget_.height / 2.0);
  centre_ = kept + cv::Point2d(0.5, 0.5) - (about - middle) / scale();
  stay_inside();
}

void PictureFrame::pan(cv::Point2d by) {
  if (!enlarged()) return;
  centre_ -= by / scale();
  stay_inside();
}

// A side that fits completely is centred.
void PictureFrame::stay_inside() {
  const auto inside = [this](double at, int picture, int widget) {
    const double half = widget / scale() / 2;
    return 2 * half >= picture ? picture / 2.0 : std::clamp(at, half, picture - half);
  };
  centre_ = {inside(centre_.x, picture_.width, widget_.width),
             inside(centre_.y, picture_.height, widget_.height)};
}

}  // namespace mbncc::console
