// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/margins.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc::decision {
namespace {

constexpr double kDisplaced = 3;  // [px]

/// Angle [rad] of the object frame, which all views of the object share.
double object_angle(const Detection& detection) {
  return detection.pose.theta + detection.view->reference_in_anchor.theta;
}

bool same_object(const Detection& a, const Detection& b) {
  return a.object == b.object;
}

bool turned(const Detection& a, const Detection& b) {
  return angle_distance(object_angle(a), object_angle(b), b.view->symmetry) > kOtherAngle;
}

/// [px] The reference point; of a symmetric object, whose reference point turns with equivalent
/// angles, the centre of symmetry.
cv::Point2d fixed_point(const Detection& detection) {
  if (detection.view->symmetry == 1) return object_pose(detection).position();
  return transform(detection.pose, detection.scale * detection.view->symmetry_centre);
}

/// Whether both the anchors and the fixed points lie apart: those of two views of one pose may do
/// so one at a time. The anchor of a symmetric object turns with equivalent angles.
bool displaced(const Detection& a, const Detection& b) {
  return cv::norm(fixed_point(a) - fixed_point(b)) >= kDisplaced &&
         (b.view->symmetry != 1 || cv::norm(a.pose.position() - b.pose.position()) >= kDisplaced);
}

/// The best detection other than `detection` for which `competes` holds; null: none. `competes` is
/// called only for detections that are better than the best one so far.
template <class Predicate>
const Detection* best_competitor(const Detection& detection, const std::vector<Detection>& all,
                                 Predicate&& competes) {
  const Detection* best = nullptr;
  for (const auto& other : all)
    if (&other != &detection &&
        (!best || log_odds_against(detection, other) > log_odds_against(detection, *best)) &&
        competes(other))
      best = &other;
  return best;
}

}  // namespace

double log_odds_against(const Detection& detection, const Detection& other) {
  return detection.odds.of_competitor(other.odds, same_object(other, detection));
}

const Detection* competing_angle(const Detection& detection, const std::vector<Detection>& all) {
  return best_competitor(detection, all, [&](const Detection& other) {
    return same_object(other, detection) && turned(other, detection) &&
           at_one_place(detection, other);
  });
}

double margin_to(const Detection& detection, const Detection* other) {
  return other ? std::min(kNoCompetitor, detection.log_odds() - other->log_odds()) : kNoCompetitor;
}

double instance_margin(const Detection& detection, const std::vector<Detection>& all,
                       const std::map<std::string, double>& elsewhere) {
  const double margin =
      margin_to(detection, best_competitor(detection, all, [&](const Detection& other) {
                  return same_object(other, detection) && !at_one_place(detection, other);
                }));
  const auto best = elsewhere.find(detection.object->name);
  return best == elsewhere.end() ? margin : std::min(margin, detection.log_odds() - best->second);
}

const Detection* competing_place(const Detection& detection, const std::vector<Detection>& all,
                                 const std::vector<const Detection*>& accepted,
                                 double max_overlap) {
  const auto explained = [&](const Detection& other) {
    return std::any_of(accepted.begin(), accepted.end(), [&](const Detection* one) {
      return one == &other || overlapping(other, *one, std::min(max_overlap, kOnePlace));
    });
  };
  return best_competitor(detection, all, [&](const Detection& other) {
    return same_object(other, detection) && !at_one_place(detection, other) && !explained(other);
  });
}

cv::Matx33d displacement_covariance(const Detection& detection, const std::vector<Detection>& all) {
  cv::Matx33d largest = cv::Matx33d::zeros();
  for (const auto& other : all) {
    if (&other == &detection || !same_object(other, detection) || turned(other, detection) ||
        !displaced(other, detection) || !at_one_place(detection, other))
      continue;
    const double margin = detection.log_odds() - log_odds_against(detection, other);
    const double probability = 1 / (1 + std::exp(margin));
    const cv::Point2d way = fixed_point(other) - fixed_point(detection);
    const double turn =
        angle_distance(object_angle(other), object_angle(detection), detection.view->symmetry);
    const cv::Matx33d covariance = probability * cv::Matx33d(way.x * way.x, way.x * way.y, 0,  //
                                                             way.x * way.y, way.y * way.y, 0,  //
                                                             0, 0, turn * turn);
    if (cv::trace(covariance) > cv::trace(largest)) largest = covariance;
  }
  return largest;
}

const Detection* competing_object(const Detection& detection, const std::vector<Detection>& all) {
  return best_competitor(detection, all, [&](const Detection& other) {
    return !same_object(other, detection) && at_one_place(detection, other);
  });
}

}  // namespace mbncc::decision
