// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/image_view.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTime>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "console/image/label_places.hpp"
#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

const QColor kInclude("#56b4e9"), kExclude("#d55e00"), kRegion("#f0e442");
const QColor kX("#d55e00"), kY("#009e73");
constexpr double kAxes = 34;               // [px] of the widget, length of a mark's axes
constexpr int kNotch = 240;                // wheel units that double the size
constexpr double kOutline = 1.5;           // [px] of the widget
constexpr double kPen = 9;                 // [px] of the widget, length of the pen's arms
constexpr double kPan = 60;                // [px] of the widget, pan per key press
constexpr float kStep = 6, kFineStep = 1;  // [px] of the image, pen motion per key press

cv::Size size_of(const QSize& size) {
  return {size.width(), size.height()};
}

QColor colour_of_tool(Tool tool) {
  if (tool == Tool::kInclude) return kInclude;
  return tool == Tool::kExclude ? kExclude : kRegion;
}

/// Direction of an arrow key; null for other keys.
QPoint way_of(int key) {
  switch (key) {
    case Qt::Key_Left:
      return {-1, 0};
    case Qt::Key_Right:
      return {1, 0};
    case Qt::Key_Up:
      return {0, -1};
    case Qt::Key_Down:
      return {0, 1};
    default:
      return {};
  }
}

std::vector<cv::Point2f> points_of(const geometry_msgs::Polygon& polygon) {
  std::vector<cv::Point2f> points;
  for (const auto& point : polygon.points) points.emplace_back(point.x, point.y);
  return points;
}

}  // namespace

QString still_caption() {
  return "Still image of " + QTime::currentTime().toString("hh:mm:ss");
}

ImageView::ImageView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(320, 240);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setFocusPolicy(Qt::StrongFocus);
  name_window(this, "image");
}

void ImageView::show_image(const QImage& image, QSize size, const std::vector<Mark>& marks,
                           const QString& caption) {
  const bool reshaped = size != size_;
  image_ = image;
  size_ = size;
  marks_ = marks;
  set_caption(caption);
  outdated_ = false;
  fit();
  update();
  if (reshaped) Q_EMIT shape_changed();
}

void ImageView::set_caption(const QString& caption) {
  if (caption == caption_) return;
  caption_ = caption;
  setAccessibleDescription(caption);
}

void ImageView::show_age(const QString& warning) {
  if (image_.isNull()) return;
  outdated_ = true;
  set_caption(warning);
  update();
}

void ImageView::show_waiting(std::deque<MarkingTool::Request> waiting) {
  if (waiting.empty() && waiting_.empty()) return;
  waiting_ = std::move(waiting);
  update();
}

void ImageView::ask_for_place(bool wanted) {
  asking_ = wanted && !image_.isNull();
  pen_.reset();
  show_cursor();
  update();
}

void ImageView::ask_for_region(bool wanted) {
  asking_region_ = wanted && !image_.isNull();
  tool_.choose(asking_region_ ? Tool::kRegion : Tool::kNone);
  // The keyboard starts to draw here.
  const cv::Size size = size_of(size_);
  pen_ = cv::Point2f(static_cast<float>(size.width) / 4, static_cast<float>(size.height) / 4);
  show_cursor();
  update();
}

void ImageView::show_region(const QRect& region) {
  if (region == region_) return;
  region_ = region;
  update();
}

bool ImageView::give_up() {
  update();
  return tool_.give_up();
}

void ImageView::show_marks(bool shown) {
  marks_shown_ = shown;
  update();
}

void ImageView::enlarge(double factor) {
  frame_.zoom(factor, {width() / 2.0, height() / 2.0});
  show_cursor();
  update();
}

void ImageView::show_all() {
  frame_.show_all();
  show_cursor();
  update();
}

// Arrow keys move the pen while a tool is active, otherwise the zoomed image.
void ImageView::keyPressEvent(QKeyEvent* event) {
  const QPoint way = way_of(event->key());
  if (!way.isNull() && !draws())
    frame_.pan({-kPan * way.x(), -kPan * way.y()});
  else if (!way.isNull())
    move_pen(way, event->modifiers() & Qt::ShiftModifier ? kFineStep : kStep);
  else if (event->key() == Qt::Key_Space && draws() && !event->isAutoRepeat())
    use_pen();
  else
    return QWidget::keyPressEvent(event);
  update();
}

bool ImageView::draws() const {
  return !image_.isNull() && (asking_ || tool_.tool() != Tool::kNone);
}

cv::Point2f ImageView::pen() const {
  const auto& axes = tool_.axes();
  const cv::Point2f start =
      asking_ ? cv::Point2f(size_of(size_)) / 2
              : cv::Point2f(static_cast<float>(axes.x), static_cast<float>(axes.y));
  return pen_.value_or(start);
}

void ImageView::move_pen(QPoint way, float step) {
  const cv::Point2f moved =
      pen() + step * cv::Point2f(static_cast<float>(way.x()), static_cast<float>(way.y()));
  pen_ = cv::Point2f(std::clamp(moved.x, 0.f, static_cast<float>(size_.width() - 1)),
                     std::clamp(moved.y, 0.f, static_cast<float>(size_.height() - 1)));
  tool_.move(*pen_);
}

/// Puts the pen down, or lifts it.
void ImageView::use_pen() {
  pen_ = pen();
  if (asking_)
    choose_place(*pen_);
  else if (!tool_.drawing())
    tool_.press(*pen_);
  else
    finish_mark(*pen_);
}

void ImageView::choose_place(cv::Point2f at) {
  ask_for_place(false);
  Q_EMIT place_chosen({at.x, at.y});
}

void ImageView::finish_mark(cv::Point2f at) {
  const auto correction = tool_.release(at, size_of(size_));
  if (!correction) return;
  if (!asking_region_) return Q_EMIT corrected(*correction);
  ask_for_region(false);
  const auto& roi = correction->roi;
  Q_EMIT region_chosen({static_cast<int>(roi.x_offset), static_cast<int>(roi.y_offset),
                        static_cast<int>(roi.width), static_cast<int>(roi.height)});
}

void ImageView::show_cursor() {
  setCursor(asking_ || tool_.tool() != Tool::kNone ? Qt::CrossCursor
            : frame_.enlarged()                    ? Qt::OpenHandCursor
                                                   : Qt::ArrowCursor);
}

void ImageView::fit() {
  frame_.set_sizes(size_of(size_), size_of(size()));
}

QPointF ImageView::on_widget(cv::Point2d image) const {
  const cv::Point2d point = frame_.to_widget(image);
  return {point.x, point.y};
}

cv::Point2f ImageView::on_image(const QPointF& widget) const {
  return cv::Point2f(frame_.to_image({widget.x(), widget.y()}));
}

void ImageView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor("#202020"));
  if (image_.isNull()) {
    painter.setPen(Qt::white);
    painter.drawText(rect(), Qt::AlignCenter, "No image from the camera yet");
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(
      QRectF(on_widget({-0.5, -0.5}), on_widget({size_.width() - 0.5, size_.height() - 0.5})),
      image_);
  if (outdated_) painter.fillRect(rect(), QColor(110, 110, 110, 190));
  painter.setRenderHint(QPainter::Antialiasing);
  if (marks_shown_ && !outdated_) {
    paint_region(painter);
    paint_marks(painter);
    paint_labels(painter);
  }
  paint_tool(painter);
  paint_pen(painter);
  paint_caption(painter);
  if (hasFocus()) paint_focus(painter);
}

/// Draws the cross at which the keyboard draws.
void ImageView::paint_pen(QPainter& painter) const {
  if (!draws() || !hasFocus()) return;
  const QPointF at = on_widget(pen());
  for (const auto& pen : {QPen(Qt::black, 4), QPen(Qt::white, 2)}) {
    painter.setPen(pen);
    painter.drawLine(at - QPointF(kPen, 0), at + QPointF(kPen, 0));
    painter.drawLine(at - QPointF(0, kPen), at + QPointF(0, kPen));
  }
}

void ImageView::paint_focus(QPainter& painter) const {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().highlight(), 2));
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

/// The part that is not searched is drawn darker.
void ImageView::paint_region(QPainter& painter) const {
  if (region_.isEmpty()) return;
  const QRectF box(on_widget({region_.x() - 0.5, region_.y() - 0.5}),
                   on_widget({region_.right() + 0.5, region_.bottom() + 0.5}));
  QPainterPath outside;
  outside.addRect(rect());
  QPainterPath inside;
  inside.addRect(box);
  painter.fillPath(outside.subtracted(inside), QColor(0, 0, 0, 110));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kRegion, 2, Qt::DashLine));
  painter.drawRect(box);
}

void ImageView::paint_marks(QPainter& painter) const {
  for (const auto& mark : marks_) {
    QPainterPath path;
    for (const auto& outline : mark.outlines) {
      QPolygonF line;
      for (const auto& point : outline) line << on_widget(point);
      path.addPolygon(line);
      path.closeSubpath();
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, kOutline + 1.5));
    painter.drawPath(path);
    QPen pen(QColor(bright_colour_of(mark.level)), kOutline);
    // Unknown states are not marked by colour alone.
    if (mark.level == Level::kUnknown) pen.setStyle(Qt::DashLine);
    painter.setPen(pen);
    painter.drawPath(path);
    if (tool_.tool() != Tool::kAxes)
      paint_axes(painter, mark.origin, mark.theta, kAxes / frame_.scale(), false);
  }
}

void ImageView::paint_labels(QPainter& painter) const {
  QFont bold = painter.font();
  bold.setBold(true);
  painter.setFont(bold);
  std::vector<LabelledThing> things;
  for (const auto& mark : marks_) {
    QRectF box(on_widget(mark.origin), QSizeF(1, 1));
    for (const auto& outline : mark.outlines)
      for (const auto& point : outline) box = box.united(QRectF(on_widget(point), QSizeF(1, 1)));
    const QRect text = painter.fontMetrics().boundingRect(QString::fromStdString(mark.label));
    const QRect whole = box.toAlignedRect();
    things.push_back({{whole.x(), whole.y(), whole.width(), whole.height()},
                      {text.width() + 10, text.height() + 4}});
  }
  const auto places = place_labels(things, {0, 0, width(), height()});
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const QRect plate(places[i].x, places[i].y, places[i].width, places[i].height);
    painter.fillRect(plate, QColor(colour_of(marks_[i].level)));
    painter.setPen(QColor(ink_on(marks_[i].level)));
    painter.drawText(plate, Qt::AlignCenter, QString::fromStdString(marks_[i].label));
  }
}

void ImageView::paint_tool(QPainter& painter) const {
  for (const auto& request : waiting_) {
    for (const auto& line : request.include)
      paint_stroke(painter, points_of(line), request.stroke_width, Tool::kInclude);
    for (const auto& line : request.exclude)
      paint_stroke(painter, points_of(line), request.stroke_width, Tool::kExclude);
  }
  if (tool_.tool() == Tool::kAxes) {
    const auto& axes = tool_.axes();
    return paint_axes(painter, {axes.x, axes.y}, axes.theta, tool_.axes_length(), true);
  }
  if (!tool_.drawing() || tool_.points().size() < 2) return;
  if (tool_.tool() != Tool::kRegion)
    return paint_stroke(painter, tool_.points(), tool_.stroke_width(), tool_.tool());
  painter.setPen(QPen(kRegion, 2, Qt::DashLine));
  painter.drawRect(QRectF(on_widget(tool_.points()[0]), on_widget(tool_.points()[1])));
}

void ImageView::paint_stroke(QPainter& painter, const std::vector<cv::Point2f>& points,
                             double width, Tool tool) const {
  QColor colour = colour_of_tool(tool);
  colour.setAlpha(170);
  QPolygonF line;
  for (const auto& point : points) line << on_widget(point);
  painter.setPen(QPen(colour, width * frame_.scale(), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
}

void ImageView::paint_axes(QPainter& painter, cv::Point2d origin, double theta, double length,
                           bool grips) const {
  const cv::Point2d x(std::cos(theta), std::sin(theta)), y(-x.y, x.x);
  const double thick = grips ? 3 : 2;
  const auto line = [&](const QColor& colour, const cv::Point2d& tip) {
    painter.setPen(QPen(Qt::black, 2 * thick));
    painter.drawLine(on_widget(origin), on_widget(tip));
    painter.setPen(QPen(colour, thick));
    painter.drawLine(on_widget(origin), on_widget(tip));
  };
  line(kY, origin + y * length);
  line(kX, origin + x * length);
  if (!grips) return;
  painter.setPen(QPen(Qt::black, 1));
  painter.setBrush(kX);
  painter.drawEllipse(on_widget(origin + x * length), 7, 7);
  painter.setBrush(Qt::white);
  painter.drawEllipse(on_widget(origin), 7, 7);
}

void ImageView::paint_caption(QPainter& painter) const {
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

void ImageView::mousePressEvent(QMouseEvent* event) {
  if (image_.isNull()) return;
  pen_.reset();
  if (event->button() == Qt::LeftButton && asking_)
    return choose_place(on_image(event->localPos()));
  const bool pans = event->button() == Qt::MiddleButton ||
                    (event->button() == Qt::LeftButton && tool_.tool() == Tool::kNone);
  if (pans)
    dragged_from_ = event->localPos();
  else if (event->button() == Qt::LeftButton)
    tool_.press(on_image(event->localPos()));
  update();
}

void ImageView::mouseMoveEvent(QMouseEvent* event) {
  if (dragged_from_) {
    const QPointF by = event->localPos() - *dragged_from_;
    dragged_from_ = event->localPos();
    frame_.pan({by.x(), by.y()});
  } else if (tool_.drawing()) {
    tool_.move(on_image(event->localPos()));
  } else {
    return show_cursor();
  }
  update();
}

void ImageView::mouseReleaseEvent(QMouseEvent* event) {
  if (dragged_from_) return dragged_from_.reset();
  if (event->button() != Qt::LeftButton) return;
  finish_mark(on_image(event->localPos()));
  update();
}

void ImageView::mouseDoubleClickEvent(QMouseEvent*) {
  show_all();
}

void ImageView::wheelEvent(QWheelEvent* event) {
  frame_.zoom(std::pow(2.0, double(event->angleDelta().y()) / kNotch),
              {event->position().x(), event->position().y()});
  update();
}

void ImageView::resizeEvent(QResizeEvent*) {
  fit();
  Q_EMIT shape_changed();
}

}  // namespace mbncc::console
