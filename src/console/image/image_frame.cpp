// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/image_frame.hpp"

#include <algorithm>

namespace mbncc::console {
namespace {

constexpr double kLargestZoom = 12;

}  // namespace

void ImageFrame::set_sizes(cv::Size image, cv::Size widget) {
  if (image.empty() || widget.empty()) return;
  if (image != image_) zoom_ = 1;
  image_ = image;
  widget_ = widget;
  fit_ = std::min(static_cast<double>(widget.width) / image.width,
                  static_cast<double>(widget.height) / image.height);
  stay_inside();
}

cv::Point2d ImageFrame::corner() const {
  const cv::Point2d centre =
      zoom_ > 1 ? centre_ : cv::Point2d(image_.width / 2.0, image_.height / 2.0);
  return cv::Point2d(widget_.width / 2.0, widget_.height / 2.0) - centre * scale();
}

// Pixel centres are at integers, so the image's corner is at -0.5.
cv::Point2d ImageFrame::to_image(cv::Point2d widget) const {
  return (widget - corner()) / scale() - cv::Point2d(0.5, 0.5);
}

cv::Point2d ImageFrame::to_widget(cv::Point2d image) const {
  return (image + cv::Point2d(0.5, 0.5)) * scale() + corner();
}

void ImageFrame::zoom(double factor, cv::Point2d about) {
  const cv::Point2d kept = to_image(about);
  zoom_ = std::clamp(zoom_ * factor, 1.0, kLargestZoom);
  // The point under the mouse stays at its position.
  const cv::Point2d middle(widget_.width / 2.0, widget_.height / 2.0);
  centre_ = kept + cv::Point2d(0.5, 0.5) - (about - middle) / scale();
  stay_inside();
}

void ImageFrame::pan(cv::Point2d by) {
  if (!enlarged()) return;
  centre_ -= by / scale();
  stay_inside();
}

// An axis along which the whole image fits is centred.
void ImageFrame::stay_inside() {
  const auto inside = [this](double at, int image, int widget) {
    const double half = widget / scale() / 2;
    return 2 * half >= image ? image / 2.0 : std::clamp(at, half, image - half);
  };
  centre_ = {inside(centre_.x, image_.width, widget_.width),
             inside(centre_.y, image_.height, widget_.height)};
}

}  // namespace mbncc::console
