#include "matching/believed.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace mbncc {
namespace {

constexpr double kSettlingCost = 1;  // log-odds that settling on the surface may cost
constexpr double kAnyCost = std::numeric_limits<double>::infinity();

Believed unsettled(const PreparedView& view, const Supported& reached) {
  return {reached.pose, reached.evidence, log_odds(reached.evidence, view.shape.area())};
}

Believed unsettled(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose) {
  return unsettled(view, {pose, gather_evidence(view.fine, scene.levels[0], pose)});
}

bool same_pose(const Pose2D& a, const Pose2D& b, double radius) {
  constexpr double kSame = 0.25;  // [px]
  return std::hypot(a.x - b.x, a.y - b.y) < kSame &&
         angle_distance(a.theta, b.theta) * radius < kSame;
}

/// Lets the surface decide in at most `iterations` steps, and for small objects all of their
/// pixels.
Believed believed(const PreparedView& view, const ScenePicture& scene, const Believed& start,
                  int iterations) {
  Believed best = unsettled(view, {start.pose, start.evidence});
  const auto adopt = [&](const Believed& other, double cost) {
    if (other.odds >= best.odds - cost)
      best = {other.pose, other.evidence, std::max(other.odds, best.odds)};
  };
  // A plain surface may drift along its shading: then the contour had it right.
  if (iterations > 0)
    adopt(unsettled(view, settle(view.fine, scene.levels[0], start.pose, iterations)),
          kSettlingCost);
  best.odds = std::max(best.odds, start.odds);
  if (view.rendering.padded() == 0 || best.odds <= kWorthRefining) return best;
  const Rendered rendered = fit(view.rendering, scene.levels[0], best.pose);
  if (iterations > 0) adopt(unsettled(view, scene, rendered.pose), kAnyCost);
  best.pixels = rendering_odds(best.evidence, rendered, view.shape.area());
  return best;
}

}  // namespace

Believed believed_as_is(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose) {
  return believed(view, scene, unsettled(view, scene, pose), 0);
}

Believed better_turned(const Believed& a, const Believed& b) {
  Believed better = rotation_odds(b.evidence) > rotation_odds(a.evidence) ? b : a;
  better.odds = std::max(a.odds, b.odds);
  return better;
}

// Narrow objects have side maxima, and shading has its own. Starts farther off are tried only where
// the near ones led elsewhere.
Believed polished(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose) {
  constexpr double kArc = 2.5;  // [px] between the starts at the rim
  constexpr int kIterations = 6;
  const double radius = view.shape.radius();
  const Supported first = climb_to_evidence(view.fine, scene.levels[0], pose, kIterations);
  Believed best = unsettled(view, first);
  bool elsewhere = false;
  for (const int turn : {-1, 1, -2, 2}) {
    if (std::abs(turn) > 1 && !elsewhere) break;
    Pose2D start = pose;
    start.theta += turn * kArc / std::max(4.0, 0.75 * radius);
    const Pose2D reached = climb(view.fine, scene.levels[0], start, kIterations).pose;
    if (same_pose(reached, first.pose, radius)) continue;
    elsewhere = true;
    best = better_turned(best, unsettled(view, scene, reached));
  }
  return best;
}

Believed settled(const PreparedView& view, const ScenePicture& scene, const Believed& start) {
  constexpr int kSettling = 8, kRefining = 4;
  Believed found = believed(view, scene, start, kSettling);
  found.refining = kRefining;
  return found;
}

}  // namespace mbncc
