#include "matching/detection.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc {
namespace {

constexpr double kSettlingCost = 1;  // log-odds that settling on the surface may cost

double fine_odds(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose) {
  return log_odds(gather_evidence(view.fine, scene.levels[0], pose), view.shape.area());
}

/// The best of several climbs from slightly turned starts: narrow objects have side maxima.
Pose2D polished(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose) {
  constexpr double kArc = 2.5;  // [px] between the starts at the rim
  Pose2D best = pose;
  double best_odds = -1e9;
  for (int k = -2; k <= 2; ++k) {
    Pose2D start = pose;
    start.theta += k * kArc / std::max(4.0, 0.75 * view.shape.radius());
    const Pose2D reached = climb(view.fine, scene.levels[0], start, 6).pose;
    const double reached_odds = fine_odds(view, scene, reached);
    if (reached_odds > best_odds) {
      best = reached;
      best_odds = reached_odds;
    }
  }
  return best;
}

Detection judged(const PreparedObject& object, const PreparedView& view, const ScenePicture& scene,
                 const Pose2D& pose, int iterations) {
  Detection detection;
  detection.object = &object;
  detection.view = &view;
  const double odds = fine_odds(view, scene, pose);
  Climbed settled = settle(view.dense, scene.levels[0], pose, iterations);
  const double settled_odds = fine_odds(view, scene, settled.pose);
  // A plain surface may drift along its shading: then the contour had it right.
  if (settled_odds < odds - kSettlingCost) settled = settle(view.dense, scene.levels[0], pose, 0);
  detection.log_odds = std::max(odds, settled_odds);
  detection.pose = settled.pose;
  detection.pose.theta = wrap_angle(settled.pose.theta);
  detection.covariance = settled.covariance;
  detection.strange = strangest_colour(view.fine, scene.levels[0], detection.pose);
  const Similarity similar = similarity(view.points, scene.grey[0], detection.pose);
  detection.similarity = similar.value;
  detection.visible = similar.visible;
  return detection;
}

}  // namespace

double Detection::score() const {
  return 1 / (1 + std::exp(-log_odds));
}

Detection judge_pose(const PreparedObject& object, const PreparedView& view,
                     const ScenePicture& scene, const Pose2D& pose) {
  return judged(object, view, scene, pose, 0);
}

Detection polish_and_judge(const PreparedObject& object, const PreparedView& view,
                           const ScenePicture& scene, const Pose2D& pose) {
  return judged(object, view, scene, polished(view, scene, pose), 8);
}

}  // namespace mbncc
