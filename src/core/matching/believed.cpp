#include "matching/believed.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mbncc {
namespace {

bool same_pose(const Pose2D& a, const Pose2D& b, double radius) {
  constexpr double kSame = 0.25;  // [px]
  return std::hypot(a.x - b.x, a.y - b.y) < kSame &&
         angle_distance(a.theta, b.theta) * radius < kSame;
}

}  // namespace

Believed believed_as_is(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose) {
  const Evidence evidence = gather_evidence(view.fine, scene.levels[0], pose);
  return {pose, evidence, log_odds(evidence, view.shape.area())};
}

// Narrow objects have side maxima, and shading has its own. Starts farther off are tried only where
// the near ones led elsewhere.
Believed polished(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose) {
  constexpr double kArc = 2.5;  // [px] between the starts at the rim
  constexpr int kIterations = 6, kRefining = 4;
  const double radius = view.shape.radius();
  const Pose2D first = climb(view.fine, scene.levels[0], pose, kIterations).pose;
  Believed best = believed_as_is(view, scene, first);
  bool elsewhere = false;
  for (const int turn : {-1, 1, -2, 2}) {
    if (std::abs(turn) > 1 && !elsewhere) break;
    Pose2D start = pose;
    start.theta += turn * kArc / std::max(4.0, 0.75 * radius);
    const Pose2D reached = climb(view.fine, scene.levels[0], start, kIterations).pose;
    if (same_pose(reached, first, radius)) continue;
    elsewhere = true;
    const Believed other = believed_as_is(view, scene, reached);
    if (rotation_odds(other.evidence) > rotation_odds(best.evidence)) best = other;
  }
  best.refining = kRefining;
  return best;
}

}  // namespace mbncc
