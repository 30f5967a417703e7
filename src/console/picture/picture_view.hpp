// SPDX-License-Identifier: BSD-3-Clause
// Shows a fitted picture with marks over it, and handles the mouse for the marking tools. The wheel
// zooms, dragging without a tool pans.
#pragma once

#ifndef Q_MOC_RUN
#include "console/lesson/marking_tool.hpp"
#include "console/picture/marks.hpp"
#include "console/picture/picture_frame.hpp"
#endif

#include <QImage>
#include <QWidget>
#include <deque>
#include <optional>
#include <vector>

namespace mbncc::console {

class PictureView : public QWidget {
  Q_OBJECT

 public:
  explicit PictureView(QWidget* parent = nullptr);

  /// `size` [px] is that of the camera's picture, which marks and tools refer to; `picture` may be
  /// a smaller copy. `caption` is written over it; "": none.
  void show_picture(const QImage& picture, QSize size, const std::vector<Mark>& marks,
                    const QString& caption);
  /// The picture is outdated: greys it out with a label until the next one.
  void show_age(const QString& warning);
  /// Shows queued corrections over the picture.
  void show_waiting(std::deque<MarkingTool::Request> waiting);

  MarkingTool& tool() { return tool_; }
  /// The next click asks about its place instead of drawing, until this is cancelled.
  void ask_for_place(bool wanted);
  bool asks_for_place() const { return asking_; }
  /// Discards an unfinished stroke; false if there is none.
  bool give_up();

  void show_marks(bool shown);
  bool marks_shown() const { return marks_shown_; }
  void enlarge(double factor);
  void show_all();
  void pan(QPoint by);

  /// As shown; null if nothing is shown.
  const QImage& picture() const { return picture_; }

  QSize sizeHint() const override { return {640, 480}; }

 Q_SIGNALS:
  void corrected(mbncc_vision::ConfirmLearning::Request correction);
  /// [px] of the camera's picture.
  void place_chosen(QPointF place);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  void show_cursor();
  QPointF on_widget(cv::Point2d picture) const;
  cv::Point2f on_picture(const QPointF& widget) const;
  void paint_marks(QPainter& painter) const;
  void paint_labels(QPainter& painter) const;
  void paint_axes(QPainter& painter, cv::Point2d origin, double theta, double length,
                  bool grips) const;
  void paint_tool(QPainter& painter) const;
  void paint_stroke(QPainter& painter, const std::vector<cv::Point2f>& points, double width,
                    Tool tool) const;
  void paint_caption(QPainter& painter) const;

  QImage picture_;
  QSize size_;
  std::vector<Mark> marks_;
  std::deque<MarkingTool::Request> waiting_;
  QString caption_;
  bool outdated_ = false, marks_shown_ = true, asking_ = false;
  std::optional<QPointF> dragged_from_;
  PictureFrame frame_;
  MarkingTool tool_;
};

}  // namespace mbncc::console
