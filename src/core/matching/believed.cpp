#include "matching/believed.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace mbncc {
namespace {

constexpr double kSettlingCost = 1;  // log-odds that settling on the surface may cost
constexpr double kAnyCost = std::numeric_limits<double>::infinity();

Supported supported(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose) {
  return {pose, gather_evidence(view.fine, scene.levels[0], pose)};
}

bool same_pose(const Pose2D& a, const Pose2D& b, double radius) {
  constexpr double kSame = 0.25;  // [px]
  return std::hypot(a.x - b.x, a.y - b.y) < kSame &&
         angle_distance(a.theta, b.theta) * radius < kSame;
}

/// Lets the surface decide in at most `iterations` steps, and for small objects all of their
/// pixels.
Believed believed(const PreparedView& view, const ScenePicture& scene, const Supported& start,
                  int iterations) {
  Believed best{start.pose, start.evidence, log_odds(start.evidence, view.shape.area())};
  const auto adopt = [&](const Supported& other, double cost) {
    const double odds = log_odds(other.evidence, view.shape.area());
    if (odds >= best.odds - cost) best = {other.pose, other.evidence, std::max(odds, best.odds)};
  };
  // A plain surface may drift along its shading: then the contour had it right.
  if (iterations > 0)
    adopt(settle(view.fine, scene.levels[0], start.pose, iterations), kSettlingCost);
  if (view.rendering.padded() == 0 || best.odds <= kWorthRefining) return best;
  const Rendered rendered = fit(view.rendering, scene.levels[0], best.pose);
  if (iterations > 0) adopt(supported(view, scene, rendered.pose), kAnyCost);
  best.pixels = rendering_odds(best.evidence, rendered, view.shape.area());
  return best;
}

}  // namespace

Believed believed_as_is(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose) {
  return believed(view, scene, supported(view, scene, pose), 0);
}

// Narrow objects have side maxima. Starts farther off are tried only where the near ones led
// elsewhere.
Supported polished(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose) {
  constexpr double kArc = 2.5;  // [px] between the starts at the rim
  constexpr int kIterations = 6;
  const double radius = view.shape.radius();
  const Supported first = climb_to_evidence(view.fine, scene.levels[0], pose, kIterations);
  Supported best = first;
  double best_odds = log_odds(best.evidence, view.shape.area());
  bool elsewhere = false;
  for (const int turn : {-1, 1, -2, 2}) {
    if (std::abs(turn) > 1 && !elsewhere) break;
    Pose2D start = pose;
    start.theta += turn * kArc / std::max(4.0, 0.75 * radius);
    const Pose2D reached = climb(view.fine, scene.levels[0], start, kIterations).pose;
    if (same_pose(reached, first.pose, radius)) continue;
    elsewhere = true;
    const Supported other = supported(view, scene, reached);
    const double odds = log_odds(other.evidence, view.shape.area());
    if (odds > best_odds) {
      best = other;
      best_odds = odds;
    }
  }
  return best;
}

Believed settled(const PreparedView& view, const ScenePicture& scene, const Supported& start) {
  constexpr int kSettling = 8, kRefining = 4;
  Believed found = believed(view, scene, start, kSettling);
  found.refining = kRefining;
  return found;
}

}  // namespace mbncc
