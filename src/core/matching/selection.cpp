#include "matching/selection.hpp"

#include <algorithm>
#include <cmath>

#include "matching/clutter.hpp"

namespace mbncc {
namespace {

constexpr double kNoCompetitor = 20;  // log-odds: margin where nothing else was found
constexpr double kStrange = 0.2;      // chroma: a part of another colour is no part of the object
constexpr double kOtherAngle = to_radians(10);

bool overlapping(const Detection& a, const Detection& b, double most) {
  return overlap(a.view->shape, a.pose, b.view->shape, b.pose) > most;
}

/// Of the object's frame, which its views share.
double object_angle(const Detection& detection) {
  return detection.pose.theta + detection.view->reference_in_anchor.theta;
}

int count_of(const std::vector<const Detection*>& accepted, const PreparedObject* object) {
  return static_cast<int>(
      std::count_if(accepted.begin(), accepted.end(),
                    [object](const Detection* other) { return other->object == object; }));
}

double min_score_of(const Detection& detection, const Acceptance& acceptance) {
  if (acceptance.min_score) return *acceptance.min_score;
  return detection.object->model->min_score.value_or(acceptance.config.min_score);
}

std::vector<const Detection*> accept(const std::vector<Detection>& detections,
                                     const Acceptance& acceptance) {
  std::vector<const Detection*> accepted;
  for (const auto& detection : detections) {
    if (acceptance_score(detection, acceptance.config) < min_score_of(detection, acceptance))
      continue;
    if (count_of(accepted, detection.object) >= acceptance.max_instances) continue;
    const bool covered =
        std::any_of(accepted.begin(), accepted.end(), [&](const Detection* better) {
          return overlapping(detection, *better, acceptance.config.max_overlap);
        });
    if (!covered) accepted.push_back(&detection);
  }
  return accepted;
}

/// Distance to the best detection for which `competes` holds.
template <class Predicate>
double margin_to(const Detection& detection, const std::vector<Detection>& all,
                 Predicate&& competes) {
  double margin = kNoCompetitor;
  for (const auto& other : all)
    if (&other != &detection && competes(other))
      margin = std::min(margin, detection.log_odds - other.log_odds);
  return margin;
}

class Margins {
 public:
  Margins(const std::vector<Detection>& all, const std::vector<const Detection*>& accepted,
          double max_overlap)
      : all_(all), accepted_(accepted), max_overlap_(max_overlap) {}

  double place(const Detection& detection) const {
    return margin_to(detection, all_, [&](const Detection& other) {
      const bool here = overlapping(detection, other, max_overlap_);
      const bool same_object = other.object == detection.object;
      return same_object ? !here && !explained(other) : here;
    });
  }

  double angle(const Detection& detection) const {
    return margin_to(detection, all_, [&](const Detection& other) {
      return other.object == detection.object &&
             angle_distance(object_angle(other), object_angle(detection),
                            detection.view->symmetry) > kOtherAngle &&
             overlapping(detection, other, max_overlap_);
    });
  }

 private:
  /// Part of another accepted instance.
  bool explained(const Detection& other) const {
    return std::any_of(accepted_.begin(), accepted_.end(), [&](const Detection* one) {
      return one == &other || overlapping(other, *one, max_overlap_);
    });
  }

  const std::vector<Detection>& all_;
  const std::vector<const Detection*>& accepted_;
  double max_overlap_;
};

cv::Matx33d moved_to_reference(const cv::Matx33d& covariance, cv::Point2d lever) {
  // Turning about the anchor moves the reference point at the lever's end sideways.
  const cv::Matx33d jacobian(1, 0, -lever.y, 0, 1, lever.x, 0, 0, 1);
  return jacobian * covariance * jacobian.t();
}

/// The pose is known well enough to reach for; the angle of a round object does not matter.
bool within_deviations(const Match& match, const SearchConfig& config) {
  const cv::Matx33d& c = match.covariance;
  const double angle = match.symmetry == 0 ? 0 : to_degrees(std::sqrt(c(2, 2)));
  return std::sqrt(std::max(c(0, 0), c(1, 1))) <= config.max_place_deviation &&
         angle <= config.max_angle_deviation;
}

/// Nearly certain, or likely and its texture is seen: mirror images and keys of another cut share
/// outline and material.
bool convincing(const Detection& detection) {
  constexpr double kCertain = 5, kLikely = 2;  // log-odds
  constexpr double kTexture = 0.6;             // correlation without shading
  return detection.log_odds >= kCertain ||
         (detection.log_odds >= kLikely && detection.projected >= kTexture);
}

/// [px] the reference point as seen from the anchor of what was found.
cv::Point2d lever_of(const Detection& detection) {
  return detection.size * detection.view->reference_in_anchor.position();
}

/// Of the object's frame.
Pose2D object_pose(const Detection& detection) {
  const cv::Point2d lever = lever_of(detection);
  return compose(detection.pose, {lever.x, lever.y, detection.view->reference_in_anchor.theta});
}

std::vector<cv::Point2f> outline_at(const Detection& detection) {
  const Pose2D pose = object_pose(detection);
  std::vector<cv::Point2f> outline;
  for (const auto& point : detection.view->outline)
    outline.emplace_back(transform(pose, detection.size * cv::Point2d(point)));
  return outline;
}

Match to_match(const Detection& detection, const Margins& margins, const SearchConfig& config) {
  const ObjectModel& model = *detection.object->model;
  const PreparedView& view = *detection.view;
  Match match;
  match.name = model.name;
  match.revision = model.revision;
  match.pose = object_pose(detection);
  match.covariance =
      moved_to_reference(detection.covariance, rotate(lever_of(detection), detection.pose.theta));
  match.scale = view.scale * detection.size;
  match.score = acceptance_score(detection, config);
  match.log_odds = detection.log_odds;
  match.similarity = detection.similarity;
  match.margin_place = margins.place(detection);
  match.margin_angle = margins.angle(detection);
  match.visible = detection.visible;
  match.symmetry = view.symmetry;
  const bool located = within_deviations(match, config) && !detection.displaced;
  const bool sure = detection.strange <= kStrange && !detection.another_size &&
                    !detection.turned_over && match.margin_place >= config.min_margin_place &&
                    match.margin_angle >= config.min_margin_angle;
  const bool enough = match.score >= config.confirm_score;
  match.graspable =
      enough && sure && convincing(detection) && located && match.visible >= config.min_visible;
  match.ambiguous = enough && !sure;
  match.outline = outline_at(detection);
  return match;
}

/// What no accepted detection of the same object covers.
std::vector<Rival> rivals_of(const std::vector<const Detection*>& accepted,
                             const std::vector<Detection>& detections, double max_overlap) {
  std::vector<Rival> rivals;
  for (const auto& detection : detections) {
    const bool explained = std::any_of(accepted.begin(), accepted.end(), [&](const auto* one) {
      return one == &detection ||
             (one->object == detection.object && overlapping(detection, *one, max_overlap));
    });
    if (explained) continue;
    rivals.push_back({detection.object->model->name, detection.log_odds, outline_at(detection)});
  }
  return rivals;
}

}  // namespace

double acceptance_score(const Detection& detection, const SearchConfig& config) {
  return config.accept_by == "similarity" ? std::max(0.0, detection.similarity) : detection.score();
}

Selection select_matches(std::vector<Detection> detections, const Acceptance& acceptance) {
  Selection selection;
  selection.clutter = discount_clutter(detections, acceptance.clutter, acceptance.rarity);
  std::stable_sort(
      detections.begin(), detections.end(), [&](const Detection& a, const Detection& b) {
        return acceptance_score(a, acceptance.config) > acceptance_score(b, acceptance.config);
      });
  const auto accepted = accept(detections, acceptance);
  const double max_overlap = acceptance.config.max_overlap;
  const Margins margins(detections, accepted, max_overlap);
  for (const Detection* detection : accepted)
    selection.matches.push_back(to_match(*detection, margins, acceptance.config));
  selection.rivals = rivals_of(accepted, detections, max_overlap);
  return selection;
}

}  // namespace mbncc
