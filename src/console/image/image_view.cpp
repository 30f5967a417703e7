// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/image_view.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTime>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "console/image/image_painter.hpp"
#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

constexpr int kNotch = 240;                // wheel units that double the size
constexpr double kPan = 60;                // [px] of the widget, pan per key press
constexpr float kStep = 6, kFineStep = 1;  // [px] of the image, pen motion per key press

cv::Size size_of(const QSize& size) {
  return {size.width(), size.height()};
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

/// [px] place of the mouse in the widget.
QPointF place_of(const QWheelEvent& event) {
#if QT_VERSION < QT_VERSION_CHECK(5, 14, 0)
  return event.posF();
#else
  return event.position();
#endif
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

cv::Point2f ImageView::on_image(const QPointF& widget) const {
  return cv::Point2f(frame_.to_image({widget.x(), widget.y()}));
}

void ImageView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor("#202020"));
  const ImagePainter over(painter, frame_, rect());
  if (image_.isNull()) return over.draw_no_image();
  over.draw_image(image_, size_);
  if (outdated_) over.draw_outdated();
  painter.setRenderHint(QPainter::Antialiasing);
  if (marks_shown_ && !outdated_) draw_marks(over);
  for (const auto& request : waiting_) over.draw_strokes(request);
  over.draw_tool(tool_);
  if (draws() && hasFocus()) over.draw_pen(pen());
  over.draw_caption(caption_);
  if (hasFocus()) over.draw_focus(palette().highlight().color());
}

void ImageView::draw_marks(const ImagePainter& over) const {
  over.draw_region(region_);
  over.draw_outlines(marks_);
  // The axes tool draws the frame itself.
  if (tool_.tool() != Tool::kAxes) over.draw_frames(marks_);
  over.draw_labels(marks_);
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
  const QPointF at = place_of(*event);
  frame_.zoom(std::pow(2.0, double(event->angleDelta().y()) / kNotch), {at.x(), at.y()});
  update();
}

void ImageView::resizeEvent(QResizeEvent*) {
  fit();
  Q_EMIT shape_changed();
}

}  // namespace mbncc::console
