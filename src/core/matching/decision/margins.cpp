// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/margins.hpp"

#include <algorithm>

namespace mbncc::decision {
namespace {

constexpr double kOtherAngle = to_radians(10);
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

cv::Point2d symmetry_centre(const Detection& detection) {
  return transform(detection.pose, detection.scale * detection.view->symmetry_centre);
}

/// Whether both the anchors and the reference points lie apart: those of two views of one pose may
/// do so one at a time. Those of a symmetric object turn with equivalent angles.
bool displaced(const Detection& a, const Detection& b) {
  if (b.view->symmetry != 1) return cv::norm(symmetry_centre(a) - symmetry_centre(b)) >= kDisplaced;
  return cv::norm(a.pose.position() - b.pose.position()) >= kDisplaced &&
         cv::norm(object_pose(a).position() - object_pose(b).position()) >= kDisplaced;
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

double margin_to(const Detection& detection, const Detection* other) {
  return other ? std::min(kNoCompetitor, detection.log_odds() - other->log_odds()) : kNoCompetitor;
}

}  // namespace

double log_odds_against(const Detection& detection, const Detection& other) {
  return detection.odds.of_competitor(other.odds, same_object(other, detection));
}

bool overlapping(const Detection& a, const Detection& b, double most) {
  return templates::overlap(a.view->shape, a.pose, b.view->shape, b.pose) > most;
}

const Detection* competing_angle(const Detection& detection, const std::vector<Detection>& all) {
  return best_competitor(detection, all, [&](const Detection& other) {
    return same_object(other, detection) && turned(other, detection) &&
           overlapping(detection, other);
  });
}

double angle_margin(const Detection& detection, const std::vector<Detection>& all) {
  return margin_to(detection, competing_angle(detection, all));
}

double instance_margin(const Detection& detection, const std::vector<Detection>& all,
                       const std::map<std::string, double>& elsewhere) {
  const double margin =
      margin_to(detection, best_competitor(detection, all, [&](const Detection& other) {
                  return same_object(other, detection) && !overlapping(detection, other);
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
    return same_object(other, detection) && !overlapping(detection, other) && !explained(other);
  });
}

const Detection* competing_shift(const Detection& detection, const std::vector<Detection>& all) {
  return best_competitor(detection, all, [&](const Detection& other) {
    return same_object(other, detection) && displaced(other, detection) &&
           !turned(other, detection) && overlapping(detection, other);
  });
}

const Detection* competing_object(const Detection& detection, const std::vector<Detection>& all) {
  return best_competitor(detection, all, [&](const Detection& other) {
    return !same_object(other, detection) && overlapping(detection, other);
  });
}

}  // namespace mbncc::decision
