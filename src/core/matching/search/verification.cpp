// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/verification.hpp"

#include <algorithm>
#include <cmath>

#include "matching/evidence/contour_alternative.hpp"
#include "matching/evidence/torn_contour.hpp"

namespace mbncc {
namespace {

constexpr double kReportable = -2.2;  // log-odds: a score of .1

/// How far colours are off where an object of log-odds `odds` is believed to lie.
ColourDifference strangeness(const PreparedView& view, const SceneLevel& scene,
                             const Refined& found, double odds) {
  if (odds <= kWorthRefining) return {};
  thread_local SurfaceSample sample;
  thread_local ContourSample contour;
  const SurfaceTemplate& surface = view.fine.surface;
  scene.prepare_around(found.pose, view.fine.reach() * found.scale);
  surface.sample(scene, found.pose, sample, found.scale);
  read_contour(view.fine.contour, scene.edges, found.pose, 1, contour, found.scale);
  return view.parts.worst_differences(
      surface, sample, contour, ground_beside(view.fine.contour, scene, found.pose, found.scale));
}

/// Log-odds that a mirrored outline takes away, which is better by so much.
double mirror_doubt(double better) {
  constexpr double kSteepness = 100;
  return kSteepness * std::max(0.0, better - kMirrored);
}

/// Log-odds that a part of another colour takes away. Fitted to drawn scenes and to photographs of
/// tools.
double doubt(double strange) {
  constexpr double kUsual = 0.15, kSteepness = 60;
  return kSteepness * std::max(0.0, strange - kUsual);
}

/// Of a pose refined to another scale: those of the object as large as that, if they are higher.
double odds_at(const PreparedView& view, const ScenePicture& scene, const PoseHypothesis& found,
               const Refined& place) {
  if (place.scale == 1) return found.odds;
  const Evidence evidence = gather_evidence(view.fine, scene.levels[0], place.pose, place.scale);
  return std::max(found.odds, log_odds(evidence, view.shape.area()));
}

/// A smaller or larger object of the same kind lies here: it fits better than one of these odds, or
/// is farther from the learned size than heights and tilts bring.
bool fits_another_size(const PreparedView& view, const ScenePicture& scene, const Refined& place,
                       double odds) {
  constexpr int kIterations = 3;
  constexpr double kUsual = 0.065;
  if (std::abs(place.scale - 1) > kUsual) return true;
  const SceneLevel& picture = scene.levels[0];
  return std::any_of(view.resized.begin(), view.resized.end(), [&](const PoseTemplate& resized) {
    const ScoredPose reached = align_and_score(resized, picture, place.pose, kIterations);
    return log_odds(reached.evidence, view.shape.area()) > odds;
  });
}

/// By how much the mirrored outline agrees better at a pose: the object lies on its other side, or
/// something else is its mirror image.
double turned_over(const PreparedView& view, const ScenePicture& scene, const Refined& place) {
  return view.turned_over.better(view.fine.contour, scene.levels[0], place.pose, place.scale);
}

Refined refined(const PreparedView& view, const ScenePicture& scene, const PoseHypothesis& found) {
  if (found.odds <= kWorthRefining) return unknown_accuracy(found.pose);
  return refine(view.dense, scene.levels[0], found.pose, found.refining);
}

/// Against other rotations at the same place; the least where none of them can be reported.
double odds_of_rotation(const PreparedView& view, const SceneLevel& scene,
                        const PoseHypothesis& found) {
  constexpr double kNone = -1000;
  thread_local SurfaceSample sample;
  if (found.odds <= kReportable - kComparable) return kNone;
  scene.prepare_around(found.pose, view.fine.reach());
  view.fine.surface.sample(scene, found.pose, sample);
  return rotation_odds(found.evidence, view.lit.misfit(sample));
}

/// What is known before the pose is refined.
Detection unrefined(const PreparedObject& object, const PreparedView& view,
                    const ScenePicture& scene, const PoseHypothesis& found) {
  Detection detection;
  detection.object = &object;
  detection.view = &view;
  detection.pose = found.pose;
  detection.pose.theta = wrap_angle(found.pose.theta);
  detection.covariance = detection.cautious = unknown_accuracy(found.pose).covariance;
  detection.log_odds = found.odds + found.pixels;
  detection.projected = found.evidence.projected;
  detection.rotation_odds = odds_of_rotation(view, scene.levels[0], found);
  return detection;
}

void read_similarity(Detection& detection, const ScenePicture& scene) {
  const Similarity read = similarity(detection.view->points, scene.grey[0], detection.pose);
  detection.similarity = read.value;
  detection.visible = read.visible;
}

/// Refines the pose, and looks for what speaks against it there.
void refine(Detection& detection, const ScenePicture& scene, const PoseHypothesis& found) {
  const PreparedView& view = *detection.view;
  const Refined place = refined(view, scene, found);
  detection.pose = place.pose;
  detection.pose.theta = wrap_angle(place.pose.theta);
  detection.size = place.scale;
  detection.covariance = place.covariance;
  detection.cautious = place.cautious;
  const double odds = odds_at(view, scene, found, place);
  const ColourDifference strange = strangeness(view, scene.levels[0], place, found.odds);
  detection.strange = std::max(strange.colour, strange.block);
  const double mirrored = found.odds > kWorthRefining ? turned_over(view, scene, place) : 0;
  detection.turned_over = mirrored > view.turned_over.limit();
  detection.log_odds = odds + found.pixels - doubt(strange.colour) - mirror_doubt(mirrored);
  detection.another_size = detection.log_odds > 0 && fits_another_size(view, scene, place, odds);
  detection.torn = detection.log_odds > 0 && better_torn(view.fine.contour, scene.levels[0],
                                                         detection.pose, detection.size) > kTorn;
}

/// Tells of the best detection at each place, of sorted ones, by how much the outline alone would
/// lie better elsewhere: shading displaces a plain surface by pixels.
void look_elsewhere(const PreparedView& view, const ScenePicture& scene,
                    std::vector<Detection>& compared) {
  for (auto one = compared.begin(); one != compared.end(); ++one) {
    if (one->log_odds <= kReportable) break;
    if (std::none_of(compared.begin(), one,
                     [&](const Detection& better) { return at_one_place(*one, better); }))
      one->elsewhere = better_elsewhere(view.fine.contour, scene.levels[0], one->pose, one->size);
  }
}

}  // namespace

std::vector<Detection> judge(const PreparedObject& object, const PreparedView& view,
                             const ScenePicture& scene, const std::vector<PoseHypothesis>& found) {
  std::vector<Detection> detections;
  for (const auto& one : found) {
    detections.push_back(unrefined(object, view, scene, one));
    detections.back().number = detections.size() - 1;
  }
  // What may be reported is not known before rotations have been compared, and what speaks against
  // one lets another be the best: so they are refined one after the other.
  std::vector<char> refined(found.size(), 0);
  for (;;) {
    auto compared = compare_rotations(detections);
    const auto next = std::find_if(compared.begin(), compared.end(), [&](const Detection& one) {
      return !refined[one.number] && one.log_odds > kReportable;
    });
    if (next != compared.end()) {
      refined[next->number] = 1;
      refine(detections[next->number], scene, found[next->number]);
      continue;
    }
    look_elsewhere(view, scene, compared);
    for (auto& one : compared) read_similarity(one, scene);
    return compared;
  }
}

}  // namespace mbncc
