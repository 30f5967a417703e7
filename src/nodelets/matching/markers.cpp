// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/markers.hpp"

#include <cmath>
#include <cstdio>

#include "nodelets/conversion/messages.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using visualization_msgs::Marker;

constexpr double kFallbackLength = 0.05;  // [m] when the size is unknown
constexpr double kLifetime = 10;          // [s] lifetime of markers without updates

double length_or(double length, double fallback) {
  return std::isfinite(length) && length > 0 ? length : fallback;
}

std_msgs::ColorRGBA colour(double r, double g, double b, double a = 1) {
  std_msgs::ColorRGBA result;
  result.r = static_cast<float>(r);
  result.g = static_cast<float>(g);
  result.b = static_cast<float>(b);
  result.a = static_cast<float>(a);
  return result;
}

// Okabe and Ito's palette, as in the overlay.
std_msgs::ColorRGBA colour_of(const DetectedObject& object) {
  const double alpha = object.state == DetectedObject::HELD ? 0.4 : 1;
  if (object.state == DetectedObject::CONFIRMED) return colour(0.34, 0.71, 0.91, alpha);
  if (object.state == DetectedObject::AMBIGUOUS) return colour(0.90, 0.62, 0, alpha);
  return colour(0.78, 0.78, 0.78, alpha);
}

Marker marker_of(const std_msgs::Header& header, const DetectedObject& object, const char* part,
                 int type) {
  Marker marker;
  marker.header = header;
  marker.ns = part;
  marker.id = static_cast<int>(object.instance_id);
  marker.type = type;
  marker.pose = object.pose.pose;
  marker.color = colour_of(object);
  marker.lifetime = ros::Duration(kLifetime);
  return marker;
}

geometry_msgs::Point point(double x, double y) {
  geometry_msgs::Point result;
  result.x = x;
  result.y = y;
  return result;
}

Marker outline_marker(const std_msgs::Header& header, const DetectedObject& object) {
  Marker line = marker_of(header, object, "outline", Marker::LINE_STRIP);
  for (const auto& corner : object.footprint.points)
    line.points.push_back(point(corner.x, corner.y));
  line.points.push_back(line.points.front());
  line.scale.x = 0.03 * length_or(object.size.x, kFallbackLength);
  return line;
}

Marker axes_of(const std_msgs::Header& header, const DetectedObject& object) {
  Marker axes = marker_of(header, object, "axes", Marker::LINE_LIST);
  const double length = 0.6 * length_or(object.size.x, kFallbackLength);
  axes.scale.x = 0.08 * length;
  axes.points = {point(0, 0), point(length, 0), point(0, 0), point(0, length)};
  const auto x = colour(0.84, 0.37, 0), y = colour(0, 0.62, 0.45);
  axes.colors = {x, x, y, y};
  return axes;
}

Marker caption_of(const std_msgs::Header& header, const DetectedObject& object) {
  Marker caption = marker_of(header, object, "caption", Marker::TEXT_VIEW_FACING);
  char score[16];
  std::snprintf(score, sizeof score, " %.2f", object.score);
  caption.text = object.name + score + "\n" + word_of(object.state);
  caption.scale.z = 0.4 * length_or(object.size.x, kFallbackLength);
  caption.color.a = 1;
  // Beside the outline, along -y of the header frame.
  caption.pose.position.y -= 1.0 * length_or(object.size.x, kFallbackLength);
  return caption;
}

}  // namespace

visualization_msgs::MarkerArray to_markers(const mbncc_vision::DetectedObjectArray& detections) {
  visualization_msgs::MarkerArray markers;
  Marker clear;
  clear.header = detections.header;
  clear.action = Marker::DELETEALL;
  markers.markers.push_back(clear);
  for (const auto& object : detections.objects) {
    if (!object.pose_valid) continue;
    if (!object.footprint.points.empty())
      markers.markers.push_back(outline_marker(detections.header, object));
    markers.markers.push_back(axes_of(detections.header, object));
    markers.markers.push_back(caption_of(detections.header, object));
  }
  return markers;
}

}  // namespace mbncc::nodelets
