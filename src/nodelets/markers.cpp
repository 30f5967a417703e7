#include "nodelets/markers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using visualization_msgs::Marker;

constexpr double kFallbackLength = 0.05;  // [m] when the size is unknown

double length_or(double length, double fallback) {
  return std::isfinite(length) && length > 0 ? length : fallback;
}

std_msgs::ColorRGBA colour_of(const DetectedObject& object) {
  std_msgs::ColorRGBA colour;
  colour.r = object.state == DetectedObject::CONFIRMED ? 0.2f : 0.9f;
  colour.g = object.state == DetectedObject::AMBIGUOUS ? 0.5f : 0.8f;
  colour.b = 0.2f;
  colour.a = object.state == DetectedObject::HELD ? 0.3f : 0.7f;
  return colour;
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
  return marker;
}

Marker box_of(const std_msgs::Header& header, const DetectedObject& object) {
  Marker box = marker_of(header, object, "extents", Marker::CUBE);
  box.scale.x = length_or(object.size.x, kFallbackLength);
  box.scale.y = length_or(object.size.y, kFallbackLength);
  box.scale.z = length_or(object.size.z, 0.002);
  return box;
}

Marker arrow_of(const std_msgs::Header& header, const DetectedObject& object) {
  Marker arrow = marker_of(header, object, "x_axis", Marker::ARROW);
  arrow.scale.x = length_or(object.size.x, kFallbackLength);
  arrow.scale.y = arrow.scale.z = 0.1 * arrow.scale.x;
  return arrow;
}

Marker caption_of(const std_msgs::Header& header, const DetectedObject& object) {
  Marker caption = marker_of(header, object, "caption", Marker::TEXT_VIEW_FACING);
  char score[16];
  std::snprintf(score, sizeof score, " %.2f", object.score);
  caption.text = object.name + score;
  caption.scale.z = 0.4 * length_or(object.size.x, kFallbackLength);
  caption.color.a = 1;
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
    markers.markers.push_back(box_of(detections.header, object));
    markers.markers.push_back(arrow_of(detections.header, object));
    markers.markers.push_back(caption_of(detections.header, object));
  }
  return markers;
}

}  // namespace mbncc::nodelets
