// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/vision/vision_messages.hpp"

#include <algorithm>
#include <boost/crc.hpp>
#include <cmath>
#include <vector>

#include "nodelets/conversion/pose_algebra.hpp"
#include "nodelets/matching/graspable.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

struct Box {
  double left = 0, right = 0, top = 0, bottom = 0;

  double x() const { return (left + right) / 2; }
  double y() const { return (top + bottom) / 2; }
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

template <class Points>
Box box_around(const Points& points) {
  if (points.empty()) return {};
  const auto x = std::minmax_element(points.begin(), points.end(),
                                     [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto y = std::minmax_element(points.begin(), points.end(),
                                     [](const auto& a, const auto& b) { return a.y < b.y; });
  return {x.first->x, x.second->x, y.first->y, y.second->y};
}

struct Point {
  double x, y;
};

Point turned(double x, double y, double theta) {
  const double c = std::cos(theta), s = std::sin(theta);
  return {c * x - s * y, s * x + c * y};
}

vision_msgs::BoundingBox2D box_in_image(const DetectedObject& object) {
  const auto& pose = object.image_pose;
  std::vector<Point> outline;
  for (const auto& corner : object.outline.points)
    outline.push_back(turned(corner.x - pose.x, corner.y - pose.y, -pose.theta));
  const Box box = box_around(outline);
  const Point middle = turned(box.x(), box.y(), pose.theta);
  vision_msgs::BoundingBox2D result;
  result.center.x = pose.x + middle.x;
  result.center.y = pose.y + middle.y;
  result.center.theta = pose.theta;
  result.size_x = box.width();
  result.size_y = box.height();
  return result;
}

vision_msgs::BoundingBox3D box_around_body(const DetectedObject& object) {
  const auto& footprint = object.footprint.points;
  const Box box = box_around(footprint);
  const double base = footprint.empty() ? 0 : footprint.front().z;
  geometry_msgs::Pose middle;
  middle.position.x = box.x();
  middle.position.y = box.y();
  middle.position.z = base / 2;
  middle.orientation.w = 1;
  vision_msgs::BoundingBox3D result;
  result.center = compose(object.pose.pose, middle);
  result.size.x = box.width();
  result.size.y = box.height();
  result.size.z = std::abs(base);
  return result;
}

vision_msgs::ObjectHypothesisWithPose hypothesis_of(const DetectedObject& object) {
  vision_msgs::ObjectHypothesisWithPose hypothesis;
  hypothesis.id = object_id(object.name);
  hypothesis.score = object.score;
  return hypothesis;
}

/// One message per object, completed by `fill`.
template <class Array, class Fill>
Array array_of(const std_msgs::Header& header, const ObjectList& objects, const ObjectIds& ids,
               const Fill& fill) {
  Array array;
  array.header = header;
  for (const auto* object : objects) {
    if (!ids.has(object->name)) continue;
    auto& detection = array.detections.emplace_back();
    detection.header = header;
    detection.results = {hypothesis_of(*object)};
    fill(detection, *object);
  }
  return array;
}

}  // namespace

std::int64_t object_id(const std::string& name) {
  boost::crc_32_type crc;
  crc.process_bytes(name.data(), name.size());
  return crc.checksum() & 0x7fffffff;
}

bool ObjectIds::add(const DetectedObjectArray& detections) {
  bool news = false;
  for (const auto& name : detections.searched) news = add(name) || news;
  for (const auto& object : detections.objects) news = add(object.name) || news;
  return news;
}

bool ObjectIds::add(const std::string& name) {
  return names_.emplace(object_id(name), name).second;
}

bool ObjectIds::has(const std::string& name) const {
  const auto found = names_.find(object_id(name));
  return found != names_.end() && found->second == name;
}

vision_msgs::Detection2DArray to_detections_2d(const DetectedObjectArray& detections,
                                               const ObjectIds& ids) {
  return array_of<vision_msgs::Detection2DArray>(
      detections.header, confirmed(detections), ids,
      [&](vision_msgs::Detection2D& detection, const DetectedObject& object) {
        detection.bbox = box_in_image(object);
        if (is_reliable(detections) && object.pose_valid) detection.results[0].pose = object.pose;
      });
}

vision_msgs::Detection3DArray to_detections_3d(const DetectedObjectArray& detections,
                                               const ObjectIds& ids) {
  return array_of<vision_msgs::Detection3DArray>(
      detections.header, graspable(detections), ids,
      [](vision_msgs::Detection3D& detection, const DetectedObject& object) {
        detection.bbox = box_around_body(object);
        detection.results[0].pose = object.pose;
      });
}

}  // namespace mbncc::nodelets
