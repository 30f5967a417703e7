// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/detection.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc::decision {
namespace {

/// Whether `roi` is empty or contains `point`. [px]
bool contains(const cv::Rect& roi, cv::Point2d point) {
  constexpr double kHalf = 0.5;  // [px] a pixel's area reaches this far beyond its centre
  return roi.empty() || (point.x >= roi.x - kHalf && point.y >= roi.y - kHalf &&
                         point.x < roi.br().x - kHalf && point.y < roi.br().y - kHalf);
}

}  // namespace

bool at_one_place(const Detection& a, const Detection& b) {
  constexpr double kApart = 0.4;  // [radii] largest distance of one place
  return cv::norm(a.pose.position() - b.pose.position()) <= kApart * b.view->shape.radius() &&
         templates::overlap(a.view->shape, a.pose, b.view->shape, b.pose) > kOnePlace;
}

cv::Point2d lever_of(const Detection& detection) {
  return detection.scale * detection.view->reference_in_anchor.position();
}

Pose2D object_pose(const Detection& detection) {
  const cv::Point2d lever = lever_of(detection);
  return compose(detection.pose, {lever.x, lever.y, detection.view->reference_in_anchor.theta});
}

std::vector<cv::Point2f> outline_at(const Detection& detection) {
  const Pose2D pose = object_pose(detection);
  std::vector<cv::Point2f> outline;
  for (const auto& point : detection.view->outline)
    outline.emplace_back(transform(pose, detection.scale * cv::Point2d(point)));
  return outline;
}

Pose2D object_pose_within(const Detection& detection, const cv::Rect& roi) {
  const Pose2D pose = object_pose(detection);
  const int symmetry = detection.view->symmetry;
  if (symmetry == 1 || contains(roi, pose.position())) return pose;
  const cv::Point2d centre =
      transform(detection.pose, detection.scale * detection.view->symmetry_centre);
  const cv::Point2d from = pose.position() - centre;
  const cv::Point2d to = cv::Point2d(roi.tl() + roi.br()) / 2 - centre;
  const auto turned = [&](double turn) {
    const cv::Point2d position = centre + rotate(from, turn);
    return Pose2D{position.x, position.y, wrap_angle(pose.theta + turn)};
  };
  for (int k = 1; k < symmetry; ++k) {
    const Pose2D equivalent = turned(k * 2 * kPi / symmetry);
    if (contains(roi, equivalent.position())) return equivalent;
  }
  return symmetry == 0 ? turned(std::atan2(from.cross(to), from.dot(to))) : pose;
}

bool reference_within(const Detection& detection, const cv::Rect& roi) {
  return contains(roi, object_pose_within(detection, roi).position());
}

std::vector<Detection> resolve_rotations(std::vector<Detection> detections) {
  const auto better = [](const Detection& a, const Detection& b) {
    return a.log_odds() > b.log_odds();
  };
  std::stable_sort(detections.begin(), detections.end(), better);
  std::vector<Detection> compared;
  while (!detections.empty()) {
    const Detection best = detections.front();
    const auto others =
        std::stable_partition(detections.begin(), detections.end(), [&](const Detection& one) {
          return one.odds.without_print() >= best.log_odds() - kComparable &&
                 at_one_place(one, best);
        });
    double most = best.rotation_odds;
    for (auto one = detections.begin(); one != others; ++one)
      most = std::max(most, one->rotation_odds);
    for (auto one = detections.begin(); one != others; ++one) {
      one->odds.best_at_place = best.log_odds();
      one->odds.resized = best.odds.resized;
      one->odds.rotation = most - one->rotation_odds;
      compared.push_back(*one);
    }
    detections.erase(detections.begin(), others);
  }
  std::stable_sort(compared.begin(), compared.end(), better);
  return compared;
}

}  // namespace mbncc::decision
