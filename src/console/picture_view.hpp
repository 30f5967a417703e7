// Shows a picture fitted in, and takes the mouse as a marking tool. The wheel enlarges.
#pragma once

#ifndef Q_MOC_RUN
#include "console/marking_tool.hpp"
#include "console/picture_frame.hpp"
#endif

#include <QImage>
#include <QWidget>

namespace mbncc::console {

class PictureView : public QWidget {
  Q_OBJECT

 public:
  explicit PictureView(QWidget* parent = nullptr);

  /// `caption` is written over the picture; "": none.
  void show_picture(const QImage& picture, const QString& caption);
  /// The picture shown is outdated: greys it and says so, until the next one.
  void show_age(const QString& warning);
  MarkingTool& tool() { return tool_; }

  QSize sizeHint() const override { return {560, 420}; }

 Q_SIGNALS:
  void corrected(mbncc_vision::ConfirmLearning::Request correction);

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
  QPointF on_widget(cv::Point2d picture) const;
  cv::Point2f on_picture(const QPointF& widget) const;
  void paint_marks(QPainter& painter) const;
  void paint_axes(QPainter& painter) const;
  void paint_caption(QPainter& painter) const;

  QImage picture_;
  QString caption_;
  bool outdated_ = false;
  PictureFrame frame_;
  MarkingTool tool_;
};

}  // namespace mbncc::console
