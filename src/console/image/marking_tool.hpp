// SPDX-License-Identifier: BSD-3-Clause
// Converts mouse input on the reviewed image to corrections of the lesson.
#pragma once

#include <geometry_msgs/Pose2D.h>
#include <mbncc_vision/ConfirmLearning.h>

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace mbncc::console {

enum class Tool { kNone, kInclude, kExclude, kRegion, kAxes };

/// All points are in pixels of the image.
class MarkingTool {
 public:
  using Request = mbncc_vision::ConfirmLearning::Request;

  void choose(Tool tool);
  Tool tool() const { return tool_; }
  void set_stroke_width(double width) { stroke_width_ = width; }
  double stroke_width() const { return stroke_width_; }

  /// The lesson's object frame, and the length of its drawn axes.
  void set_axes(const geometry_msgs::Pose2D& axes, double length);

  /// Discards an unfinished stroke; false if there is none.
  bool give_up();

  void press(cv::Point2f at);
  void move(cv::Point2f to);
  /// The drawn correction; none if it is too small.
  std::optional<Request> release(cv::Point2f at, cv::Size image);

  bool drawing() const { return drawing_; }
  /// Points of the stroke, or two opposite corners of the region.
  const std::vector<cv::Point2f>& points() const { return points_; }
  /// The axes as they are being dragged.
  const geometry_msgs::Pose2D& axes() const { return axes_; }
  double axes_length() const { return axes_length_; }

 private:
  std::optional<Request> stroke() const;
  std::optional<Request> region(cv::Size image) const;
  std::optional<Request> reference() const;

  Tool tool_ = Tool::kNone;
  double stroke_width_ = 8;
  bool drawing_ = false;
  bool turning_ = false;
  std::vector<cv::Point2f> points_;
  geometry_msgs::Pose2D axes_, axes_before_;
  double axes_length_ = 40;
};

}  // namespace mbncc::console
