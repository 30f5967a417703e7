// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/image_painter.hpp"

#include <QPainterPath>
#include <cmath>

#include "console/image/label_places.hpp"
#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

const QColor kInclude("#56b4e9"), kExclude("#d55e00"), kRegion("#f0e442");
const QColor kX("#d55e00"), kY("#009e73");
constexpr double kAxes = 34;      // [px] of the widget, length of a mark's axes
constexpr double kOutline = 1.5;  // [px] of the widget
constexpr double kPen = 9;        // [px] of the widget, length of the pen's arms
constexpr double kGrip = 7;       // [px] of the widget, radius

QColor colour_of_tool(Tool tool) {
  if (tool == Tool::kInclude) return kInclude;
  return tool == Tool::kExclude ? kExclude : kRegion;
}

std::vector<cv::Point2f> points_of(const geometry_msgs::Polygon& polygon) {
  std::vector<cv::Point2f> points;
  for (const auto& point : polygon.points) points.emplace_back(point.x, point.y);
  return points;
}

cv::Point2d direction(double theta) {
  return {std::cos(theta), std::sin(theta)};
}

}  // namespace

ImagePainter::ImagePainter(QPainter& painter, const ImageFrame& frame, const QRect& widget)
    : painter_(painter), frame_(frame), widget_(widget) {}

QPointF ImagePainter::on_widget(cv::Point2d image) const {
  const cv::Point2d point = frame_.to_widget(image);
  return {point.x, point.y};
}

void ImagePainter::set_bold() const {
  QFont font = painter_.font();
  font.setBold(true);
  painter_.setFont(font);
}

void ImagePainter::draw_image(const QImage& image, QSize size) const {
  painter_.setRenderHint(QPainter::SmoothPixmapTransform);
  painter_.drawImage(
      QRectF(on_widget({-0.5, -0.5}), on_widget({size.width() - 0.5, size.height() - 0.5})), image);
}

void ImagePainter::draw_no_image() const {
  painter_.setPen(Qt::white);
  painter_.drawText(widget_, Qt::AlignCenter, "No image from the camera yet");
}

void ImagePainter::draw_outdated() const {
  painter_.fillRect(widget_, QColor(110, 110, 110, 190));
}

void ImagePainter::draw_region(const QRect& region) const {
  if (region.isEmpty()) return;
  const QRectF box(on_widget({region.x() - 0.5, region.y() - 0.5}),
                   on_widget({region.right() + 0.5, region.bottom() + 0.5}));
  QPainterPath outside;
  outside.addRect(widget_);
  QPainterPath inside;
  inside.addRect(box);
  painter_.fillPath(outside.subtracted(inside), QColor(0, 0, 0, 110));
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(QPen(kRegion, 2, Qt::DashLine));
  painter_.drawRect(box);
}

void ImagePainter::draw_outlines(const std::vector<Mark>& marks) const {
  painter_.setBrush(Qt::NoBrush);
  for (const auto& mark : marks) {
    QPainterPath path;
    for (const auto& outline : mark.outlines) {
      QPolygonF line;
      for (const auto& point : outline) line << on_widget(point);
      path.addPolygon(line);
      path.closeSubpath();
    }
    painter_.setPen(QPen(Qt::black, kOutline + 1.5));
    painter_.drawPath(path);
    QPen pen(QColor(bright_colour_of(mark.level)), kOutline);
    // Unknown states are not marked by colour alone.
    if (mark.level == Level::kUnknown) pen.setStyle(Qt::DashLine);
    painter_.setPen(pen);
    painter_.drawPath(path);
  }
}

void ImagePainter::draw_frames(const std::vector<Mark>& marks) const {
  for (const auto& mark : marks) draw_axes(mark.origin, mark.theta, kAxes / frame_.scale(), 2);
}

void ImagePainter::draw_labels(const std::vector<Mark>& marks) const {
  set_bold();
  std::vector<LabelledThing> things;
  for (const auto& mark : marks) {
    QRectF box(on_widget(mark.origin), QSizeF(1, 1));
    for (const auto& outline : mark.outlines)
      for (const auto& point : outline) box = box.united(QRectF(on_widget(point), QSizeF(1, 1)));
    const QRect text = painter_.fontMetrics().boundingRect(QString::fromStdString(mark.label));
    const QRect whole = box.toAlignedRect();
    things.push_back({{whole.x(), whole.y(), whole.width(), whole.height()},
                      {text.width() + 10, text.height() + 4}});
  }
  const auto places = place_labels(things, {0, 0, widget_.width(), widget_.height()});
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const QRect plate(places[i].x, places[i].y, places[i].width, places[i].height);
    painter_.fillRect(plate, QColor(colour_of(marks[i].level)));
    painter_.setPen(QColor(ink_on(marks[i].level)));
    painter_.drawText(plate, Qt::AlignCenter, QString::fromStdString(marks[i].label));
  }
}

void ImagePainter::draw_tool(const MarkingTool& tool) const {
  if (tool.tool() == Tool::kAxes) {
    const auto& axes = tool.axes();
    draw_axes({axes.x, axes.y}, axes.theta, tool.axes_length(), 3);
    return draw_grips({axes.x, axes.y}, axes.theta, tool.axes_length());
  }
  if (!tool.drawing() || tool.points().size() < 2) return;
  if (tool.tool() != Tool::kRegion)
    return draw_stroke(tool.points(), tool.stroke_width(), tool.tool());
  painter_.setPen(QPen(kRegion, 2, Qt::DashLine));
  painter_.drawRect(QRectF(on_widget(tool.points()[0]), on_widget(tool.points()[1])));
}

void ImagePainter::draw_strokes(const MarkingTool::Request& request) const {
  for (const auto& line : request.include)
    draw_stroke(points_of(line), request.stroke_width, Tool::kInclude);
  for (const auto& line : request.exclude)
    draw_stroke(points_of(line), request.stroke_width, Tool::kExclude);
}

void ImagePainter::draw_stroke(const std::vector<cv::Point2f>& points, double width,
                               Tool tool) const {
  QColor colour = colour_of_tool(tool);
  colour.setAlpha(170);
  QPolygonF line;
  for (const auto& point : points) line << on_widget(point);
  painter_.setPen(QPen(colour, width * frame_.scale(), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter_.drawPolyline(line);
}

void ImagePainter::draw_axes(cv::Point2d origin, double theta, double length, double thick) const {
  const cv::Point2d x = direction(theta), y(-x.y, x.x);
  const auto line = [&](const QColor& colour, const cv::Point2d& tip) {
    painter_.setPen(QPen(Qt::black, 2 * thick));
    painter_.drawLine(on_widget(origin), on_widget(tip));
    painter_.setPen(QPen(colour, thick));
    painter_.drawLine(on_widget(origin), on_widget(tip));
  };
  line(kY, origin + y * length);
  line(kX, origin + x * length);
}

void ImagePainter::draw_grips(cv::Point2d origin, double theta, double length) const {
  painter_.setPen(QPen(Qt::black, 1));
  painter_.setBrush(kX);
  painter_.drawEllipse(on_widget(origin + direction(theta) * length), kGrip, kGrip);
  painter_.setBrush(Qt::white);
  painter_.drawEllipse(on_widget(origin), kGrip, kGrip);
}

void ImagePainter::draw_pen(cv::Point2f at) const {
  const QPointF centre = on_widget(at);
  for (const auto& pen : {QPen(Qt::black, 4), QPen(Qt::white, 2)}) {
    painter_.setPen(pen);
    painter_.drawLine(centre - QPointF(kPen, 0), centre + QPointF(kPen, 0));
    painter_.drawLine(centre - QPointF(0, kPen), centre + QPointF(0, kPen));
  }
}

void ImagePainter::draw_caption(const QString& text) const {
  if (text.isEmpty()) return;
  set_bold();
  const QRect box = painter_.fontMetrics().boundingRect(text).adjusted(-8, -4, 8, 4);
  const QRect plate(6, 6, box.width(), box.height());
  painter_.fillRect(plate, QColor(0, 0, 0, 170));
  painter_.setPen(Qt::white);
  painter_.drawText(plate, Qt::AlignCenter, text);
}

void ImagePainter::draw_focus(const QColor& colour) const {
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(QPen(colour, 2));
  painter_.drawRect(widget_.adjusted(1, 1, -1, -1));
}

}  // namespace mbncc::console
