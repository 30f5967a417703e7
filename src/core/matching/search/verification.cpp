// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/verification.hpp"

#include <algorithm>
#include <cmath>

#include "matching/evidence/contour_alternative.hpp"
#include "matching/refinement/gauss_newton.hpp"
#include "matching/search/outline_alternatives.hpp"
#include "matching/template/colours_beside.hpp"

namespace mbncc::search {
namespace {

constexpr double kReportable = -2.2;  // log-odds of a score of .1
constexpr int kRefinementSteps = 4;   // at most

/// Log-odds penalty of a mirrored outline that fits better by this much.
double mirror_penalty(double better) {
  constexpr double kSteepness = 100;
  return kSteepness * std::max(0.0, better - evidence::kMirrored);
}

/// Log-odds penalty of a part of another colour. Fitted to drawn scenes and to photographs of
/// tools.
double colour_penalty(double difference) {
  constexpr double kUsual = 0.15, kSteepness = 60;
  return kSteepness * std::max(0.0, difference - kUsual);
}

/// Log-odds penalty of another print, see PrintDifference::enclosed.
double print_penalty(double enclosed) {
  constexpr double kUsual = 0.2, kSteepness = 5;
  return kSteepness * std::max(0.0, enclosed - kUsual);
}

/// A refined pose with its log-odds.
struct RefinedPose {
  refinement::Refined at;
  double odds;  ///< log-odds at the refined pose, or before the refinement if higher
};

RefinedPose with_odds(const prepared::PreparedView& view, const scene::SceneImage& scene,
                      const PoseHypothesis& found, const refinement::Refined& place) {
  if (place.scale == 1) return {place, found.odds};
  return {place, std::max(found.odds, score_as_is(view, scene, place.pose, place.scale).odds)};
}

/// A pose at the size that fits best.
struct SizedPose {
  RefinedPose place;
  /// The size differs by more than heights and tilts cause, or such a size fits better.
  bool implausible_size = false;
};

/// Refines a pose found at the learned size also from other sizes if they fit better, because the
/// edges of a large object of another size are out of the refinement's reach. The farther size is
/// tested only on the side where the nearer one fits better than the learned size.
SizedPose at_best_size(const prepared::PreparedView& view, const scene::SceneImage& scene,
                       const PoseHypothesis& found, const RefinedPose& start, int steps) {
  constexpr double kUsual = 0.065;  // relative change of size by heights and tilts, at most
  constexpr int kIterations = 3;
  const auto aligned_in = [&](const templates::PoseTemplate& size, const Pose2D& from) {
    return aligned_from(view, size, scene.levels[0], from, kIterations);
  };
  SizedPose best{start};
  for (const prepared::ResizedTemplates& resized : view.resized) {
    RefinedPose from = start;
    if (start.at.scale == 1) {
      const PoseHypothesis reached = aligned_in(resized.near, start.at.pose);
      if (reached.odds <= start.odds) continue;
      const RefinedPose again = with_odds(
          view, scene, found,
          refinement::refine(view.dense, scene.levels[0], reached.pose, steps, resized.scale));
      if (again.odds > from.odds) from = again;
    } else if ((start.at.scale - 1) * (resized.scale - 1) < 0) {
      continue;
    }
    if (from.odds > best.place.odds) best.place = from;
    if (aligned_in(resized.farther, from.at.pose).odds > best.place.odds)
      best.implausible_size = true;
  }
  if (std::abs(best.place.at.scale - 1) > kUsual) best.implausible_size = true;
  return best;
}

refinement::Refined refined(const prepared::PreparedView& view, const scene::SceneImage& scene,
                            const PoseHypothesis& found, int steps) {
  if (found.odds <= kMinOddsToRefine) return refinement::unknown_accuracy(found.pose);
  return refinement::refine(view.dense, scene.levels[0], found.pose, steps);
}

/// Log-odds against other rotations at the same place; the smallest value if the pose cannot be
/// reported.
double odds_of_rotation(const prepared::PreparedView& view, const scene::SceneLevel& scene,
                        const PoseHypothesis& found) {
  constexpr double kNone = -1000;
  templates::SurfaceSample sample;
  if (found.odds <= kReportable - decision::kComparable) return kNone;
  const templates::SurfaceTemplate& surface = view.fine.surface;
  surface.sample(scene.around(found.pose, view.fine.reach()), found.pose, sample);
  return evidence::rotation_odds(found.evidence, view.ratios.misfit(surface, sample));
}

/// The detection before refinement.
decision::Detection unrefined(const prepared::PreparedObject& object,
                              const prepared::PreparedView& view, const scene::SceneImage& scene,
                              const PoseHypothesis& found) {
  decision::Detection detection;
  detection.object = object.model.get();
  detection.view = &view;
  detection.view_number = static_cast<std::size_t>(&view - object.views.data());
  detection.pose = found.pose;
  detection.pose.theta = wrap_angle(found.pose.theta);
  detection.covariance = detection.grasp_covariance =
      refinement::unknown_accuracy(found.pose).covariance;
  detection.odds = log_odds_of_pose(found.odds);
  detection.rotation_odds = odds_of_rotation(view, scene.levels[0], found);
  return detection;
}

void read_similarity(const prepared::PreparedView& view, const scene::SceneImage& scene,
                     decision::Detection& detection) {
  const Similarity read = similarity(view.points, scene.grey[0], detection.pose);
  detection.similarity = read.value;
  detection.visible = read.visible;
}

/// Compares colours and print at a refined pose. Returns the print's difference.
evidence::PrintDifference compare_surface(const prepared::PreparedView& view,
                                          const scene::SceneLevel& scene, double odds,
                                          const refinement::Refined& place,
                                          decision::Detection& detection) {
  templates::PoseSample sample;
  sample.read(view.fine, scene, place.pose, 0, place.scale);
  detection.colour_difference =
      odds <= kMinOddsToRefine
          ? 0
          : view.parts.worst_difference(
                view.fine.surface, sample.surface, sample.contour,
                templates::background_colour(view.fine.contour, scene, place.pose, place.scale));
  const auto print = view.print.difference(scene, view.fine, sample, place.pose, place.scale);
  detection.print_difference = print.largest;
  return print;
}

/// Sets everything that is computed at a refined pose.
void evaluate(const prepared::PreparedView& view, const scene::SceneImage& scene,
              const PoseHypothesis& found, const RefinedPose& refined,
              decision::Detection& detection) {
  const refinement::Refined& place = refined.at;
  detection.pose = place.pose;
  detection.pose.theta = wrap_angle(place.pose.theta);
  detection.scale = place.scale;
  detection.covariance = place.covariance;
  detection.grasp_covariance = place.grasp_covariance;
  detection.scale_variance = place.scale_variance;
  const double mirrored = found.odds > kMinOddsToRefine
                              ? mirrored_advantage({view, scene, place.pose, place.scale})
                              : 0;
  detection.mirror_alternative = mirrored > 0;
  const auto print = compare_surface(view, scene.levels[0], found.odds, place, detection);
  detection.odds = log_odds_of_pose(refined.odds, colour_penalty(detection.colour_difference),
                                    mirror_penalty(mirrored), print_penalty(print.enclosed));
  detection.odds.resized = refined.odds - found.odds;
}

/// Refines the pose by at most `steps` and tests the alternatives.
void refine(const prepared::PreparedView& view, const scene::SceneImage& scene,
            const PoseHypothesis& found, int steps, decision::Detection& detection) {
  const RefinedPose place = with_odds(view, scene, found, refined(view, scene, found, steps));
  evaluate(view, scene, found, place, detection);
  // Other sizes are not tested for an unlikely pose, which may still become the best rotation at a
  // likely place.
  detection.size_alternative = true;
  if (detection.log_odds() <= 0) return;
  const SizedPose sized = at_best_size(view, scene, found, place, steps);
  if (sized.place.odds > place.odds) evaluate(view, scene, found, sized.place, detection);
  detection.size_alternative = sized.implausible_size;
}

/// The first of the detections up to `one` that is at its place.
template <class Iterator>
Iterator best_of_place(Iterator first, Iterator one) {
  return std::find_if(first, one, [&](const decision::Detection& better) {
    return decision::at_one_place(*one, better);
  });
}

/// Refines the detections that can be reported.
class Refinements {
 public:
  Refinements(const prepared::PreparedView& view, const scene::SceneImage& scene,
              const std::vector<PoseHypothesis>& found)
      : view_(view), scene_(scene), found_(found), taken_(found.size(), -1) {}

  /// Which poses can be reported depends on the comparison of rotations, and the penalties of one
  /// can make another the best, so they are refined one after the other.
  void run(std::vector<decision::Detection>& detections) {
    for (;;) {
      const auto compared = decision::resolve_rotations(detections);
      auto next = compared.begin();
      while (next != compared.end() && !is_due(compared.begin(), next)) ++next;
      if (next == compared.end()) return;
      const int steps = steps_for(compared.begin(), next);
      taken_[next->number] = steps;
      refine(
          view_, scene_, found_[next->number], steps,
          *std::find_if(detections.begin(), detections.end(), [&](const decision::Detection& one) {
            return one.number == next->number;
          }));
    }
  }

 private:
  using Ranked = std::vector<decision::Detection>::const_iterator;

  bool is_due(Ranked first, Ranked one) const {
    return one->log_odds() > kReportable && taken_[one->number] < steps_for(first, one);
  }

  /// The best of a place is refined, because the covariance at the pose of the search is too small.
  /// Other rotations keep their poses unless they were aligned or the best for a time: refined,
  /// they may move to the best pose, which would then have no competitor.
  int steps_for(Ranked first, Ranked one) const {
    const bool moves = found_[one->number].aligned || best_of_place(first, one) == one;
    return moves ? kRefinementSteps : 0;
  }

  const prepared::PreparedView& view_;
  const scene::SceneImage& scene_;
  const std::vector<PoseHypothesis>& found_;
  std::vector<int> taken_;  // steps of refinement, by number; -1: not refined
};

/// The detections in groups that do not compete with each other.
std::vector<std::vector<decision::Detection>> by_place(
    const std::vector<decision::Detection>& detections) {
  std::vector<int> labels;
  const int count = cv::partition(detections, labels, decision::at_one_place);
  std::vector<std::vector<decision::Detection>> places(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < detections.size(); ++i)
    places[static_cast<std::size_t>(labels[i])].push_back(detections[i]);
  return places;
}

/// Computes what is tested for the best pose of a place only: details of the print, parts beyond
/// the outline or absent inside it, the advantage of the outline at nearby places, because shading
/// displaces a plain surface by pixels, and of its ends, and whether the pose is torn.
void examine(const prepared::PreparedView& view, const scene::SceneImage& scene,
             decision::Detection& detection) {
  const scene::SceneLevel& level = scene.levels[0];
  const templates::ContourTemplate& contour = view.fine.contour;
  const Pose2D& pose = detection.pose;
  const double scale = detection.scale;
  templates::PoseSample sample;
  sample.read(view.fine, level, pose, 0, scale);
  detection.edge_difference =
      view.interior_edges.difference(level, contour, sample.contour, pose, scale);
  detection.detail_difference =
      view.print.difference_in_detail(level, view.fine, sample, pose, scale);
  const evidence::MissingContrast missing =
      view.outline_contrast.missing(level, view.fine, sample, pose, scale);
  detection.continued = missing.continued;
  detection.absent = missing.absent;
  detection.contour_alternative = evidence::advantage_elsewhere(contour, level, pose, scale);
  detection.size_alternative |=
      evidence::advantage_of_displaced_end(contour, level, pose, scale) > evidence::kOtherLength;
  detection.torn = is_torn({view, scene, pose, scale});
}

/// Examines the best pose of each place. The others share what goes on beyond its outline, so that
/// the score does not prefer a pose for not having been examined.
void examine_best_of_places(const prepared::PreparedView& view, const scene::SceneImage& scene,
                            std::vector<decision::Detection>& compared) {
  for (auto one = compared.begin(); one != compared.end(); ++one) {
    if (one->log_odds() <= kReportable) break;
    const auto best = best_of_place(compared.begin(), one);
    if (best == one)
      examine(view, scene, *one);
    else
      one->continued = best->continued;
  }
}

}  // namespace

std::vector<decision::Detection> verify(const prepared::PreparedObject& object,
                                        const prepared::PreparedView& view,
                                        const scene::SceneImage& scene,
                                        const std::vector<PoseHypothesis>& found) {
  if (found.empty()) return {};  // cv::partition() reads the first of its elements
  std::vector<decision::Detection> detections;
  for (const auto& one : found) {
    detections.push_back(unrefined(object, view, scene, one));
    detections.back().number = detections.size() - 1;
  }
  Refinements refinements(view, scene, found);
  for (auto& place : by_place(detections)) {
    refinements.run(place);
    for (const auto& one : place) detections[one.number] = one;
  }
  refinements.run(detections);  // a refined pose may have reached another place
  auto compared = decision::resolve_rotations(std::move(detections));
  examine_best_of_places(view, scene, compared);
  for (auto& one : compared) read_similarity(view, scene, one);
  return compared;
}

}  // namespace mbncc::search
