// SPDX-License-Identifier: BSD-3-Clause
// Draws over the shown image: marks with their labels, the search region, strokes, axes, the pen
// and the caption. All places are in pixels of the camera's image; lines keep their width at any
// zoom.
#pragma once

#include <QColor>
#include <QImage>
#include <QPainter>
#include <QRect>
#include <QString>
#include <opencv2/core.hpp>
#include <vector>

#include "console/image/image_frame.hpp"
#include "console/image/marking_tool.hpp"
#include "console/image/marks.hpp"

namespace mbncc::console {

class ImagePainter {
 public:
  /// `widget` [px] is drawn by `painter`, in which `frame` places the image.
  ImagePainter(QPainter& painter, const ImageFrame& frame, const QRect& widget);

  /// `size` [px] of the camera's image, of which `image` may be a smaller copy.
  void draw_image(const QImage& image, QSize size) const;
  void draw_no_image() const;
  /// Greys out everything drawn so far.
  void draw_outdated() const;
  /// The part that is not searched is drawn darker; an empty region: the whole image is searched.
  void draw_region(const QRect& region) const;
  void draw_outlines(const std::vector<Mark>& marks) const;
  /// The axes of each mark's frame.
  void draw_frames(const std::vector<Mark>& marks) const;
  void draw_labels(const std::vector<Mark>& marks) const;
  /// What the tool has drawn, and the axes it drags.
  void draw_tool(const MarkingTool& tool) const;
  /// The strokes of a correction that was not yet answered.
  void draw_strokes(const MarkingTool::Request& request) const;
  /// The cross at which the keyboard draws.
  void draw_pen(cv::Point2f at) const;
  /// Nothing if the text is empty.
  void draw_caption(const QString& text) const;
  void draw_focus(const QColor& colour) const;

 private:
  QPointF on_widget(cv::Point2d image) const;
  void set_bold() const;
  void draw_stroke(const std::vector<cv::Point2f>& points, double width, Tool tool) const;
  void draw_axes(cv::Point2d origin, double theta, double length, double thick) const;
  void draw_grips(cv::Point2d origin, double theta, double length) const;

  QPainter& painter_;
  const ImageFrame& frame_;
  QRect widget_;
};

}  // namespace mbncc::console
