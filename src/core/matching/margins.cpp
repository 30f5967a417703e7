#include "matching/margins.hpp"

#include <algorithm>

namespace mbncc {
namespace {

constexpr double kOtherAngle = to_radians(10);

/// Of the object's frame, which its views share.
double object_angle(const Detection& detection) {
  return detection.pose.theta + detection.view->reference_in_anchor.theta;
}

bool same_object(const Detection& a, const Detection& b) {
  return a.object == b.object;
}

/// To the best detection for which `competes` holds; that is asked only of those that matter.
template <class Predicate>
double margin_to(const Detection& detection, const std::vector<Detection>& all,
                 Predicate&& competes) {
  double margin = kNoCompetitor;
  for (const auto& other : all) {
    const double ahead = detection.log_odds - other.log_odds;
    if (ahead < margin && &other != &detection && competes(other)) margin = ahead;
  }
  return margin;
}

}  // namespace

bool overlapping(const Detection& a, const Detection& b, double most) {
  return overlap(a.view->shape, a.pose, b.view->shape, b.pose) > most;
}

double angle_margin(const Detection& detection, const std::vector<Detection>& all,
                    double max_overlap) {
  return margin_to(detection, all, [&](const Detection& other) {
    return same_object(other, detection) &&
           angle_distance(object_angle(other), object_angle(detection), detection.view->symmetry) >
               kOtherAngle &&
           overlapping(detection, other, max_overlap);
  });
}

double instance_margin(const Detection& detection, const std::vector<Detection>& all,
                       double max_overlap) {
  return margin_to(detection, all, [&](const Detection& other) {
    return same_object(other, detection) && !overlapping(detection, other, max_overlap);
  });
}

double place_margin(const Detection& detection, const std::vector<Detection>& all,
                    const std::vector<const Detection*>& accepted, double max_overlap) {
  const auto explained = [&](const Detection& other) {
    return std::any_of(accepted.begin(), accepted.end(), [&](const Detection* one) {
      return one == &other || overlapping(other, *one, max_overlap);
    });
  };
  return margin_to(detection, all, [&](const Detection& other) {
    const bool here = overlapping(detection, other, max_overlap);
    return same_object(other, detection) ? !here && !explained(other) : here;
  });
}

}  // namespace mbncc
