#include "console/picture_view.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

const QColor kInclude("#56b4e9"), kExclude("#d55e00"), kRegion("#f0e442");
const QColor kX("#d55e00"), kY("#009e73");

cv::Size size_of(const QSize& size) {
  return {size.width(), size.height()};
}

QColor colour_of_tool(Tool tool) {
  if (tool == Tool::kInclude) return kInclude;
  return tool == Tool::kExclude ? kExclude : kRegion;
}

}  // namespace

PictureView::PictureView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(320, 240);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  name_window(this, "picture");
}

void PictureView::show_picture(const QImage& picture, const QString& caption) {
  picture_ = picture;
  caption_ = caption;
  outdated_ = false;
  fit();
  update();
}

void PictureView::show_age(const QString& warning) {
  if (picture_.isNull()) return;
  outdated_ = true;
  caption_ = warning;
  update();
}

void PictureView::fit() {
  frame_.set_sizes(size_of(picture_.size()), size_of(size()));
}

QPointF PictureView::on_widget(cv::Point2d picture) const {
  const cv::Point2d point = frame_.to_widget(picture);
  return {point.x, point.y};
}

cv::Point2f PictureView::on_picture(const QPointF& widget) const {
  return cv::Point2f(frame_.to_picture({widget.x(), widget.y()}));
}

void PictureView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor("#202020"));
  if (picture_.isNull()) {
    painter.setPen(Qt::white);
    painter.drawText(rect(), Qt::AlignCenter, "No picture from the camera yet");
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(
      QRectF(on_widget({-0.5, -0.5}), on_widget({picture_.width() - 0.5, picture_.height() - 0.5})),
      picture_);
  if (outdated_) painter.fillRect(rect(), QColor(110, 110, 110, 190));
  painter.setRenderHint(QPainter::Antialiasing);
  paint_marks(painter);
  paint_caption(painter);
}

void PictureView::paint_marks(QPainter& painter) const {
  if (tool_.tool() == Tool::kAxes) return paint_axes(painter);
  if (!tool_.drawing() || tool_.points().size() < 2) return;
  QColor colour = colour_of_tool(tool_.tool());
  if (tool_.tool() == Tool::kRegion) {
    painter.setPen(QPen(colour, 2, Qt::DashLine));
    painter.drawRect(QRectF(on_widget(tool_.points()[0]), on_widget(tool_.points()[1])));
    return;
  }
  colour.setAlpha(170);
  QPolygonF line;
  for (const auto& point : tool_.points()) line << on_widget(point);
  painter.setPen(QPen(colour, tool_.stroke_width() * frame_.scale(), Qt::SolidLine, Qt::RoundCap,
                      Qt::RoundJoin));
  painter.drawPolyline(line);
}

void PictureView::paint_axes(QPainter& painter) const {
  const auto& axes = tool_.axes();
  const cv::Point2d origin(axes.x, axes.y);
  const cv::Point2d x(std::cos(axes.theta), std::sin(axes.theta)), y(-x.y, x.x);
  const auto line = [&](const QColor& colour, const cv::Point2d& tip) {
    painter.setPen(QPen(Qt::black, 6));
    painter.drawLine(on_widget(origin), on_widget(tip));
    painter.setPen(QPen(colour, 3));
    painter.drawLine(on_widget(origin), on_widget(tip));
  };
  line(kY, origin + y * tool_.axes_length());
  line(kX, origin + x * tool_.axes_length());
  painter.setPen(QPen(Qt::black, 1));
  painter.setBrush(kX);
  painter.drawEllipse(on_widget(origin + x * tool_.axes_length()), 7, 7);
  painter.setBrush(Qt::white);
  painter.drawEllipse(on_widget(origin), 7, 7);
}

void PictureView::paint_caption(QPainter& painter) const {
  if (caption_.isEmpty()) return;
  QFont font = painter.font();
  font.setBold(true);
  painter.setFont(font);
  const QRect box = painter.fontMetrics().boundingRect(caption_).adjusted(-8, -4, 8, 4);
  const QRect plate(6, 6, box.width(), box.height());
  painter.fillRect(plate, QColor(0, 0, 0, 170));
  painter.setPen(Qt::white);
  painter.drawText(plate, Qt::AlignCenter, caption_);
}

void PictureView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || picture_.isNull()) return;
  tool_.press(on_picture(event->localPos()));
  update();
}

void PictureView::mouseMoveEvent(QMouseEvent* event) {
  if (!tool_.drawing()) return;
  tool_.move(on_picture(event->localPos()));
  update();
}

void PictureView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const auto correction = tool_.release(on_picture(event->localPos()), size_of(picture_.size()));
  if (correction) Q_EMIT corrected(*correction);
  update();
}

void PictureView::mouseDoubleClickEvent(QMouseEvent*) {
  frame_.show_all();
  update();
}

void PictureView::wheelEvent(QWheelEvent* event) {
  frame_.zoom(std::pow(2.0, event->angleDelta().y() / 240.0),
              {event->position().x(), event->position().y()});
  update();
}

void PictureView::resizeEvent(QResizeEvent*) {
  fit();
}

}  // namespace mbncc::console
