// SPDX-License-Identifier: BSD-3-Clause
// The position of a picture in a widget: completely fitted, or zoomed.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::console {

class PictureFrame {
 public:
  void set_sizes(cv::Size picture, cv::Size widget);
  /// Zooms by `factor` about a point of the widget, at least to the fitted size.
  void zoom(double factor, cv::Point2d about);
  void show_all() { zoom_ = 1; }
  /// Pans the zoomed picture by widget pixels, within its edges.
  void pan(cv::Point2d by);
  bool enlarged() const { return zoom_ > 1; }

  cv::Point2d to_picture(cv::Point2d widget) const;
  cv::Point2d to_widget(cv::Point2d picture) const;
  /// Widget pixels per picture pixel.
  double scale() const { return fit_ * zoom_; }

 private:
  cv::Point2d corner() const;
  void stay_inside();

  cv::Size picture_{1, 1}, widget_{1, 1};
  double fit_ = 1;
  double zoom_ = 1;
  cv::Point2d centre_{0.5, 0.5};  // [px] of the picture, in the middle of the widget
};

}  // namespace mbncc::console
