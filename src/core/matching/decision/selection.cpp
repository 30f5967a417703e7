// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/selection.hpp"

#include <algorithm>
#include <limits>

#include "matching/decision/clutter.hpp"
#include "matching/decision/conclusion.hpp"
#include "matching/decision/margins.hpp"
#include "matching/decision/score_calibration.hpp"

namespace mbncc::decision {
namespace {

int count_of(const std::vector<const Detection*>& accepted, const ObjectModel* object) {
  return static_cast<int>(
      std::count_if(accepted.begin(), accepted.end(),
                    [object](const Detection* other) { return other->object == object; }));
}

double min_score_of(const Detection& detection, const AcceptanceSettings& acceptance) {
  if (acceptance.min_score) return *acceptance.min_score;
  return detection.object->min_score.value_or(acceptance.config.min_score);
}

/// Appends the detections for which `is_candidate` holds and that overlap no better one, at most
/// `max_instances` of each object.
template <class Predicate>
void accept(const std::vector<Detection>& detections, const AcceptanceSettings& acceptance,
            int max_instances, const Predicate& is_candidate,
            std::vector<const Detection*>& accepted) {
  for (const auto& detection : detections) {
    if (!is_candidate(detection)) continue;
    if (acceptance_score(detection, acceptance.config) < min_score_of(detection, acceptance))
      continue;
    if (count_of(accepted, detection.object) >= max_instances) continue;
    const bool covered =
        std::any_of(accepted.begin(), accepted.end(), [&](const Detection* better) {
          return overlapping(detection, *better, acceptance.config.max_overlap);
        });
    if (!covered) accepted.push_back(&detection);
  }
}

/// Covariance of the reference point, which lies off the anchor by `lever` [px]: a rotation about
/// the anchor displaces it, and so does another size of the object.
cv::Matx33d moved_to_reference(const cv::Matx33d& covariance, cv::Point2d lever,
                               const Detection& detection) {
  const cv::Vec3d outwards(lever.x / detection.scale, lever.y / detection.scale, 0);
  return covariance_at(covariance, lever) + detection.scale_variance * outwards * outwards.t();
}

/// Sets the calibration of all detections from their margins, before any of them is accepted.
void calibrate(std::vector<Detection>& detections, const AcceptanceSettings& acceptance) {
  for (auto& detection : detections)
    detection.odds.calibration =
        calibration(detection, margin_to(detection, competing_angle(detection, detections)),
                    instance_margin(detection, detections, acceptance.elsewhere));
}

/// `other` as a competitor of `match`, which was made from `detection`, with log-odds comparable to
/// those of the match.
Competitor competitor_of(const Match& match, const Detection& detection, const Detection& other) {
  return {other.object->name, object_pose(other).position(),
          match.log_odds() - (detection.log_odds() - log_odds_against(detection, other))};
}

Match to_match(const Detection& detection, const std::vector<Detection>& all,
               const std::vector<const Detection*>& accepted,
               const AcceptanceSettings& acceptance) {
  const SearchConfig& config = acceptance.config;
  const ObjectModel& model = *detection.object;
  const templates::ViewFrame& view = *detection.view;
  Match match;
  match.name = model.name;
  match.revision = model.revision;
  match.pose = object_pose(detection);
  const cv::Point2d lever = rotate(lever_of(detection), detection.pose.theta);
  const cv::Matx33d displaced = displacement_covariance(detection, all);
  match.covariance = moved_to_reference(detection.covariance, lever, detection) + displaced;
  match.scale = view.scale * detection.scale;
  match.score = acceptance_score(detection, config);
  match.odds = detection.odds;
  match.similarity = detection.similarity;
  for (const Detection* other : {competing_place(detection, all, accepted, config.max_overlap),
                                 competing_object(detection, all)})
    if (other) match.competitors.push_back(competitor_of(match, detection, *other));
  const Detection* turned = competing_angle(detection, all);
  match.margin_angle = margin_to(detection, turned);
  if (turned) match.other_angle = object_pose(*turned).theta;
  match.visible = detection.visible;
  match.symmetry = view.symmetry;
  match.to_symmetry_centre =
      transform(detection.pose, detection.scale * view.symmetry_centre) - match.pose.position();
  match.outline = outline_at(detection);
  match.doubts = doubts_about(
      match, detection,
      moved_to_reference(detection.grasp_covariance, lever, detection) + displaced, config);
  conclude(match, config);
  return match;
}

std::vector<Rival> rivals_of(const std::vector<const Detection*>& reported,
                             const std::vector<Detection>& detections, const cv::Rect& part) {
  std::vector<Rival> rivals;
  for (const auto& detection : detections) {
    if (std::find(reported.begin(), reported.end(), &detection) != reported.end()) continue;
    rivals.push_back({detection.object->name, object_pose(detection).position(), detection.odds,
                      outline_at(detection), reference_within(detection, part)});
  }
  return rivals;
}

}  // namespace

double acceptance_score(const Detection& detection, const SearchConfig& config) {
  return config.accept_by == "similarity" ? std::max(0.0, detection.similarity)
                                          : detection.odds.score();
}

Selection select_matches(std::vector<Detection> detections, const AcceptanceSettings& acceptance) {
  Selection selection;
  selection.clutter = apply_clutter_penalty(detections, acceptance.clutter,
                                            multiple_testing_penalty(acceptance.objects));
  calibrate(detections, acceptance);
  std::stable_sort(
      detections.begin(), detections.end(), [&](const Detection& a, const Detection& b) {
        return acceptance_score(a, acceptance.config) > acceptance_score(b, acceptance.config);
      });
  const auto is_asked_for = [&](const Detection& one) {
    return reference_within(one, acceptance.part);
  };
  std::vector<const Detection*> accepted;
  accept(detections, acceptance, acceptance.max_instances, is_asked_for, accepted);
  const std::vector<const Detection*> reported = accepted;
  // Other instances do not compete as places. An alternative to what is asked for is none.
  const auto is_other_instance = [&](const Detection& one) {
    return !is_asked_for(one) &&
           std::none_of(detections.begin(), detections.end(), [&](const Detection& other) {
             return is_asked_for(other) && at_one_place(one, other);
           });
  };
  accept(detections, acceptance, std::numeric_limits<int>::max(), is_other_instance, accepted);
  for (const Detection* detection : reported)
    selection.matches.push_back(
        equivalent_towards(object_pose_within(*detection, acceptance.part).theta,
                           to_match(*detection, detections, accepted, acceptance)));
  selection.rivals = rivals_of(reported, detections, acceptance.part);
  return selection;
}

}  // namespace mbncc::decision
