// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/marking_tool.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace mbncc::console {
namespace {

constexpr float kStep = 1.5f;     // [px] between two points of a stroke
constexpr double kMeant = 3;      // [px] shorter drags are ignored
constexpr double kGrabTip = 0.5;  // of the axes' length: radius in which the tip is grabbed

geometry_msgs::Polygon polygon_of(const std::vector<cv::Point2f>& points) {
  geometry_msgs::Polygon polygon;
  for (const auto& point : points) {
    auto& corner = polygon.points.emplace_back();
    corner.x = point.x;
    corner.y = point.y;
  }
  return polygon;
}

}  // namespace

void MarkingTool::choose(Tool tool) {
  tool_ = tool;
  drawing_ = false;
  points_.clear();
}

bool MarkingTool::give_up() {
  if (!drawing_) return false;
  drawing_ = false;
  points_.clear();
  axes_ = axes_before_;
  return true;
}

void MarkingTool::set_axes(const geometry_msgs::Pose2D& axes, double length) {
  if (drawing_) return;
  axes_ = axes_before_ = axes;
  axes_length_ = length;
}

void MarkingTool::press(cv::Point2f at) {
  if (tool_ == Tool::kNone) return;
  drawing_ = true;
  points_ = {at};
  axes_before_ = axes_;
  const cv::Point2d tip(axes_.x + axes_length_ * std::cos(axes_.theta),
                        axes_.y + axes_length_ * std::sin(axes_.theta));
  turning_ = cv::norm(cv::Point2d(at) - tip) < kGrabTip * axes_length_;
}

void MarkingTool::move(cv::Point2f to) {
  if (!drawing_) return;
  if (tool_ == Tool::kRegion) {
    points_.resize(1);
    points_.push_back(to);
  } else if (tool_ == Tool::kAxes && turning_) {
    axes_.theta = std::atan2(to.y - axes_.y, to.x - axes_.x);
  } else if (tool_ == Tool::kAxes) {
    axes_.x = axes_before_.x + to.x - points_.front().x;
    axes_.y = axes_before_.y + to.y - points_.front().y;
  } else if (cv::norm(to - points_.back()) >= kStep) {
    points_.push_back(to);
  }
}

std::optional<MarkingTool::Request> MarkingTool::release(cv::Point2f at, cv::Size image) {
  if (!drawing_) return {};
  if (at != points_.back()) move(at);
  drawing_ = false;
  if (tool_ == Tool::kRegion) return region(image);
  return tool_ == Tool::kAxes ? reference() : stroke();
}

std::optional<MarkingTool::Request> MarkingTool::stroke() const {
  Request request;
  request.command = Request::EDIT;
  request.stroke_width = static_cast<float>(stroke_width_);
  // Ignores clicks and double clicks.
  if (cv::boundingRect(points_).width < kMeant && cv::boundingRect(points_).height < kMeant)
    return {};
  (tool_ == Tool::kInclude ? request.include : request.exclude).push_back(polygon_of(points_));
  return request;
}

std::optional<MarkingTool::Request> MarkingTool::region(cv::Size image) const {
  if (points_.size() < 2) return {};
  const auto clamped = [](float v, int high) { return std::clamp(cvRound(v), 0, high); };
  const cv::Point a(clamped(points_[0].x, image.width), clamped(points_[0].y, image.height));
  const cv::Point b(clamped(points_[1].x, image.width), clamped(points_[1].y, image.height));
  const cv::Rect box(a, b);
  if (box.width < kMeant || box.height < kMeant) return {};
  Request request;
  request.command = Request::EDIT;
  request.roi.x_offset = static_cast<std::uint32_t>(box.x);
  request.roi.y_offset = static_cast<std::uint32_t>(box.y);
  request.roi.width = static_cast<std::uint32_t>(box.width);
  request.roi.height = static_cast<std::uint32_t>(box.height);
  return request;
}

std::optional<MarkingTool::Request> MarkingTool::reference() const {
  const double moved = std::hypot(axes_.x - axes_before_.x, axes_.y - axes_before_.y);
  const double turned = axes_length_ * std::abs(axes_.theta - axes_before_.theta);
  if (std::max(moved, turned) < 1) return {};
  Request request;
  request.command = Request::EDIT;
  request.set_reference = true;
  request.reference = axes_;
  return request;
}

}  // namespace mbncc::console
