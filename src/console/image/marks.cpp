// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/marks.hpp"

#include <algorithm>
#include <cstdio>
#include <opencv2/imgproc.hpp>

namespace mbncc::console {
namespace {

using mbncc_vision::DetectedObject;

std::vector<cv::Point2f> points_of(const geometry_msgs::Polygon& polygon) {
  std::vector<cv::Point2f> points;
  for (const auto& point : polygon.points) points.emplace_back(point.x, point.y);
  return points;
}

Mark mark_of(const DetectedObject& object) {
  Mark mark;
  mark.outlines = {points_of(object.outline)};
  mark.origin = {object.image_pose.x, object.image_pose.y};
  mark.theta = object.image_pose.theta;
  mark.level = level_of_state(object.state);
  char score[16];
  std::snprintf(score, sizeof score, " %.2f ", object.score);
  // Detections in a single image have no instance number.
  const std::string number =
      object.instance_id == 0 ? "" : " #" + std::to_string(object.instance_id);
  mark.label = std::string(symbol_of(mark.level)) + " " + object.name + number + score +
               word_of_state(object.state);
  return mark;
}

/// Contours of the map's pixels.
std::vector<std::vector<cv::Point>> outlines_of(const sensor_msgs::Image& map) {
  if (map.width == 0 || map.data.size() < std::size_t{map.step} * map.height) return {};
  const cv::Mat pixels(static_cast<int>(map.height), static_cast<int>(map.width), CV_8UC1,
                       const_cast<std::uint8_t*>(map.data.data()), map.step);
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(pixels.clone(), outlines, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  return outlines;
}

}  // namespace

std::vector<Mark> marks_of(const mbncc_vision::DetectedObjectArray& detections) {
  std::vector<Mark> marks;
  for (const auto& object : detections.objects) marks.push_back(mark_of(object));
  return marks;
}

std::vector<Mark> marks_of(const mbncc_vision::LearnObjectResult& draft) {
  const auto parts = outlines_of(draft.map);
  const auto outline = points_of(draft.object.outline);
  if (parts.empty() || outline.empty()) return {};
  // The message gives the position of the largest outline only; it locates the map in the image.
  const auto largest = std::max_element(
      parts.begin(), parts.end(),
      [](const auto& a, const auto& b) { return cv::contourArea(a) < cv::contourArea(b); });
  Mark mark;
  mark.origin = {draft.object.reference.x, draft.object.reference.y};
  mark.theta = draft.object.reference.theta;
  float left = outline[0].x, top = outline[0].y;
  for (const auto& point : outline) {
    left = std::min(left, point.x);
    top = std::min(top, point.y);
  }
  const cv::Rect box = cv::boundingRect(*largest);
  const cv::Point2f shift = cv::Point2f(mark.origin) + cv::Point2f(left, top) -
                            cv::Point2f(static_cast<float>(box.x), static_cast<float>(box.y));
  for (const auto& part : parts) {
    auto& placed = mark.outlines.emplace_back();
    for (const auto& point : part) placed.push_back(cv::Point2f(point) + shift);
  }
  mark.level = level_of_verdict(draft.object.quality.verdict);
  mark.label = std::string(symbol_of(mark.level)) + " " + draft.object.name + " " +
               word_of_verdict(draft.object.quality.verdict);
  return {mark};
}

}  // namespace mbncc::console
