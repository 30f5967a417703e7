// SPDX-License-Identifier: BSD-3-Clause
#include "console/detections/detection_rows.hpp"

#include <cmath>
#include <cstdio>

namespace mbncc::console {
namespace {

using mbncc_vision::DetectedObject;

constexpr double kDegrees = 180 / 3.14159265358979323846;

template <class... Values>
std::string text(const char* format, Values... values) {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

/// Text with one decimal, and without a minus sign for zero.
std::string tenths(double value) {
  const double rounded = std::round(10 * value) / 10;
  return text("%.1f", rounded == 0 ? 0.0 : rounded);
}

double yaw_of(const geometry_msgs::Quaternion& q) {
  return std::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
}

DetectionRow row_of(const DetectedObject& object, double age) {
  DetectionRow row;
  row.level = level_of_state(object.state);
  const auto& position = object.pose.pose.position;
  const bool metric = object.pose_valid;
  const double yaw = metric ? yaw_of(object.pose.pose.orientation) : object.image_pose.theta;
  row.cells = {object.name + text(" #%u", object.instance_id),
               symbol_of(row.level) + (" " + word_of_state(object.state)),
               metric ? tenths(1000 * position.x) + " mm" : tenths(object.image_pose.x) + " px",
               metric ? tenths(1000 * position.y) + " mm" : tenths(object.image_pose.y) + " px",
               object.symmetry == 0 ? "round" : tenths(kDegrees * yaw) + "\u00b0",
               text("%.2f", object.score),
               text("%.1f s", age)};
  for (const auto& reason : object.reasons)
    row.reasons += (row.reasons.empty() ? "" : "\n") + reason;
  return row;
}

}  // namespace

const std::array<const char*, 7>& detection_headings() {
  static const std::array<const char*, 7> headings{
      {"Object", "State", "x", "y", "Angle", "Score", "Age"}};
  return headings;
}

std::vector<DetectionRow> detection_rows(const mbncc_vision::DetectedObjectArray& detections,
                                         double age) {
  std::vector<DetectionRow> rows;
  for (const auto& object : detections.objects) rows.push_back(row_of(object, age));
  return rows;
}

}  // namespace mbncc::console
