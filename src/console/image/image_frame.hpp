// SPDX-License-Identifier: BSD-3-Clause
// The position of an image in a widget: fitted completely, or zoomed in.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::console {

class ImageFrame {
 public:
  void set_sizes(cv::Size image, cv::Size widget);
  /// Zooms by `factor` about a point of the widget, but never below the fitted size.
  void zoom(double factor, cv::Point2d about);
  void show_all() { zoom_ = 1; }
  /// Pans the zoomed image by widget pixels, within its edges.
  void pan(cv::Point2d by);
  bool enlarged() const { return zoom_ > 1; }

  cv::Point2d to_image(cv::Point2d widget) const;
  cv::Point2d to_widget(cv::Point2d image) const;
  /// Widget pixels per image pixel.
  double scale() const { return fit_ * zoom_; }

 private:
  cv::Point2d corner() const;
  void stay_inside();

  cv::Size image_{1, 1}, widget_{1, 1};
  double fit_ = 1;
  double zoom_ = 1;
  cv::Point2d centre_{0.5, 0.5};  // [px] image point in the middle of the widget
};

}  // namespace mbncc::console
