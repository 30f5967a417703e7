// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/pose_hypothesis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mbncc::search {
namespace {

bool same_pose(const Pose2D& a, const Pose2D& b, double radius) {
  constexpr double kSame = 0.25;  // [px]
  return std::hypot(a.x - b.x, a.y - b.y) < kSame &&
         angle_distance(a.theta, b.theta) * radius < kSame;
}

PoseHypothesis without_pixels(const prepared::PreparedView& view,
                              const refinement::ScoredPose& reached) {
  return {reached.pose, reached.evidence, evidence::log_odds(reached.evidence, view.shape.area())};
}

PoseHypothesis without_pixels(const prepared::PreparedView& view, const scene::ScenePicture& scene,
                              const Pose2D& pose) {
  return without_pixels(view, {pose, evidence::gather_evidence(view.fine, scene.levels[0], pose)});
}

/// Log-odds added by the mixed-pixel fit `rendered` of a small object of `area` [px], at the pose
/// of `evidence`.
double rendering_odds(const evidence::Evidence& evidence, const refinement::MixedPixelFit& rendered,
                      double area) {
  // Fitted by logistic regression to the same poses after log_odds() and the discount for clutter;
  // minus .85, because a right place at a wrong angle is wrong, too. Another brightness counts
  // against the object, but exposure may also change.
  constexpr double kBrighter = 0.4;
  return 4.85 - 4.22 * rendered.misfit - 6.35 * std::min(std::abs(rendered.brightness), kBrighter) -
         0.89 * evidence.contour_coverage + 1.38 * evidence.trimmed_residual +
         3.07 * evidence.histogram - 1.95 * evidence.shading_free_ncc + 0.37 * std::log(area);
}

}  // namespace

PoseHypothesis score_as_is(const prepared::PreparedView& view, const scene::ScenePicture& scene,
                           const Pose2D& pose) {
  PoseHypothesis found = without_pixels(view, scene, pose);
  if (view.rendering.padded() > 0 && found.odds > kWorthRefining)
    found.pixels = rendering_odds(
        found.evidence, refinement::fit(view.rendering, scene.levels[0], pose), view.shape.area());
  return found;
}

PoseHypothesis better_rotation(const PoseHypothesis& a, const PoseHypothesis& b) {
  return evidence::rotation_odds(b.evidence) > evidence::rotation_odds(a.evidence) ? b : a;
}

// Narrow objects and shading cause side maxima. More distant starts are tried only if the near ones
// converged elsewhere.
PoseHypothesis multistart_align(const prepared::PreparedView& view,
                                const scene::ScenePicture& scene, const Pose2D& pose) {
  constexpr double kArc = 2.5;  // [px] between the starts at the rim
  constexpr int kIterations = 6;
  const double radius = view.shape.radius();
  const refinement::ScoredPose first =
      refinement::align_and_score(view.fine, scene.levels[0], pose, kIterations);
  PoseHypothesis best = without_pixels(view, first);
  bool elsewhere = false;
  for (const int turn : {-1, 1, -2, 2}) {
    if (std::abs(turn) > 1 && !elsewhere) break;
    Pose2D start = pose;
    start.theta += turn * kArc / std::max(4.0, 0.75 * radius);
    const Pose2D reached = refinement::align(view.fine, scene.levels[0], start, kIterations).pose;
    if (same_pose(reached, first.pose, radius)) continue;
    elsewhere = true;
    best = better_rotation(best, without_pixels(view, scene, reached));
  }
  return best;
}

PoseHypothesis finalised(const prepared::PreparedView& view, const scene::ScenePicture& scene,
                         const PoseHypothesis& start) {
  constexpr int kRefining = 4;
  PoseHypothesis found = start;
  if (view.rendering.padded() == 0) {
    found.refining = kRefining;
  } else if (start.odds > kWorthRefining) {
    const refinement::MixedPixelFit rendered =
        refinement::fit(view.rendering, scene.levels[0], start.pose);
    found = without_pixels(view, scene, rendered.pose);
    found.pixels = rendering_odds(found.evidence, rendered, view.shape.area());
  }
  return found;
}

}  // namespace mbncc::search
