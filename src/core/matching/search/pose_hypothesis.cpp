// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/pose_hypothesis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "matching/refinement/gauss_newton.hpp"

namespace mbncc::search {
namespace {

constexpr std::size_t kMostAligned = 8;
// Log-odds behind the best from which on poses are not aligned
constexpr double kAlignmentMargin = 8;

bool same_pose(const Pose2D& a, const Pose2D& b, double radius) {
  constexpr double kSame = 0.25;  // [px]
  return std::hypot(a.x - b.x, a.y - b.y) < kSame &&
         angle_distance(a.theta, b.theta) * radius < kSame;
}

/// Whether `pose` is a duplicate of one of `poses`.
bool is_one_of(const std::vector<Pose2D>& poses, const Pose2D& pose, double radius) {
  return std::any_of(poses.begin(), poses.end(),
                     [&](const Pose2D& other) { return same_pose(other, pose, radius); });
}

}  // namespace

PoseHypothesis aligned_from(const prepared::PreparedView& view,
                            const templates::PoseTemplate& object, const scene::SceneLevel& scene,
                            const Pose2D& start, int iterations) {
  const refinement::ScoredPose reached =
      refinement::align_and_score(object, scene, start, iterations);
  return {reached.pose, reached.evidence, evidence::log_odds(reached.evidence, view.shape.area())};
}

PoseHypothesis score_as_is(const prepared::PreparedView& view, const scene::SceneImage& scene,
                           const Pose2D& pose, double scale) {
  const auto evidence = evidence::gather_evidence(view.fine, scene.levels[0], pose, scale);
  return {pose, evidence, evidence::log_odds(evidence, view.shape.area())};
}

PoseHypothesis better_rotation(const PoseHypothesis& a, const PoseHypothesis& b) {
  return evidence::rotation_odds(b.evidence) > evidence::rotation_odds(a.evidence) ? b : a;
}

// Narrow objects and shading cause secondary maxima. More distant starts are tried only if the near
// ones converged elsewhere.
PoseHypothesis multistart_align(const prepared::PreparedView& view, const scene::SceneImage& scene,
                                const Pose2D& pose) {
  constexpr double kArc = 2.5;  // [px] between the starts at the rim
  constexpr int kIterations = 6;
  const double radius = view.shape.radius();
  const PoseHypothesis first = aligned_from(view, view.fine, scene.levels[0], pose, kIterations);
  PoseHypothesis best = first;
  bool elsewhere = false;
  for (const int turn : {-1, 1, -2, 2}) {
    if (std::abs(turn) > 1 && !elsewhere) break;
    Pose2D start = pose;
    start.theta += turn * kArc / std::max(4.0, 0.75 * radius);
    const Pose2D reached = refinement::align(view.fine, scene.levels[0], start, kIterations).pose;
    if (same_pose(reached, first.pose, radius)) continue;
    elsewhere = true;
    best = better_rotation(best, score_as_is(view, scene, reached));
  }
  best.aligned = true;
  return best;
}

std::vector<PoseHypothesis> hypotheses(const prepared::PreparedView& view,
                                       const scene::SceneImage& scene,
                                       const std::vector<templates::Candidate>& candidates,
                                       double promising) {
  std::vector<PoseHypothesis> found;
  std::vector<Pose2D> reached;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const templates::Candidate& candidate = candidates[i];
    if (i >= kMostAligned || candidate.value <= promising ||
        candidate.value <= candidates.front().value - kAlignmentMargin) {
      found.push_back(score_as_is(view, scene, candidate.pose));
      continue;
    }
    const PoseHypothesis top = multistart_align(view, scene, candidate.pose);
    if (is_one_of(reached, top.pose, view.shape.radius())) continue;
    reached.push_back(top.pose);
    found.push_back(top);
  }
  return found;
}

}  // namespace mbncc::search
