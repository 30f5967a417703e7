// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/detection.hpp"

#include <algorithm>

#include "matching/decision/equivalent_pose.hpp"

namespace mbncc::decision {

bool overlapping(const Detection& a, const Detection& b, double most) {
  return templates::overlap(a.view->shape, a.pose, b.view->shape, b.pose) > most;
}

bool at_one_place(const Detection& a, const Detection& b) {
  return overlapping(a, b, kOnePlace);
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

Pose2D object_pose_within(const Detection& detection, const cv::Rect& region) {
  return equivalent_within(
      region, object_pose(detection), detection.view->symmetry,
      transform(detection.pose, detection.scale * detection.view->symmetry_centre));
}

bool reference_within(const Detection& detection, const cv::Rect& region) {
  return contains(region, object_pose_within(detection, region).position());
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
        std::stable_partition(detections.begin() + 1, detections.end(), [&](const Detection& one) {
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
