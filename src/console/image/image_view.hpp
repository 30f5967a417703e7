// SPDX-License-Identifier: BSD-3-Clause
// Shows an image fitted to the widget with marks over it, and takes the mouse, or arrow keys and
// Space, as a marking tool. The wheel zooms; without a tool, dragging or arrow keys pan the zoomed
// image.
#pragma once

#ifndef Q_MOC_RUN
#include "console/image/image_frame.hpp"
#include "console/image/marking_tool.hpp"
#include "console/image/marks.hpp"
#endif

#include <QImage>
#include <QRect>
#include <QWidget>
#include <deque>
#include <optional>
#include <vector>

namespace mbncc::console {

class ImagePainter;

/// "Still image of 12:03:05", with the current time, so that the image is not mistaken for a live
/// one.
QString still_caption();

class ImageView : public QWidget {
  Q_OBJECT

 public:
  explicit ImageView(QWidget* parent = nullptr);

  /// `size` [px] of the camera's image, which marks and tools refer to; `image` may be a smaller
  /// copy. `caption` is written over it; "": none.
  void show_image(const QImage& image, QSize size, const std::vector<Mark>& marks,
                  const QString& caption);
  /// Greys out an outdated image and labels it until the next one arrives.
  void show_age(const QString& warning);
  /// Shows queued corrections over the image.
  void show_waiting(std::deque<MarkingTool::Request> waiting);

  MarkingTool& tool() { return tool_; }
  /// The next click chooses a place instead of drawing, until this is cancelled.
  void ask_for_place(bool wanted);
  bool asks_for_place() const { return asking_; }
  /// The next box drawn becomes the search region, until this is cancelled.
  void ask_for_region(bool wanted);
  bool asks_for_region() const { return asking_region_; }
  /// Search region [px] in the camera's image; empty: the whole image.
  void show_region(const QRect& region);
  /// Discards an unfinished stroke; false if there is none.
  bool give_up();

  void show_marks(bool shown);
  bool marks_shown() const { return marks_shown_; }
  void enlarge(double factor);
  void show_all();
  /// Size [px] of the camera's image; empty if none was shown.
  QSize shape() const { return size_; }

  /// The image as shown; null if nothing is shown.
  const QImage& image() const { return image_; }

  QSize sizeHint() const override { return {640, 480}; }

 Q_SIGNALS:
  void corrected(mbncc_vision::ConfirmLearning::Request correction);
  /// The size of the image or of the widget has changed.
  void shape_changed();
  /// `place` [px] in the camera's image.
  void place_chosen(QPointF place);
  /// `region` [px] in the camera's image.
  void region_chosen(QRect region);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  void set_caption(const QString& caption);
  void show_cursor();
  cv::Point2f on_image(const QPointF& widget) const;
  void draw_marks(const ImagePainter& over) const;
  bool draws() const;
  cv::Point2f pen() const;
  void move_pen(QPoint way, float step);
  void use_pen();
  void choose_place(cv::Point2f at);
  void finish_mark(cv::Point2f at);

  QImage image_;
  QSize size_;
  std::vector<Mark> marks_;
  std::deque<MarkingTool::Request> waiting_;
  QString caption_;
  bool outdated_ = false, marks_shown_ = true, asking_ = false, asking_region_ = false;
  QRect region_;
  std::optional<QPointF> dragged_from_;
  std::optional<cv::Point2f> pen_;  // [px] of the image, once the keyboard has moved it
  ImageFrame frame_;
  MarkingTool tool_;
};

}  // namespace mbncc::console
