#include "mbncc/cell/pose_average.hpp"

#include <cmath>

namespace mbncc {
namespace {

constexpr double kSameAngle = 15 * kPi / 180;  // [rad]

/// Difference of two angles, wrapped into half a symmetry step about zero.
double turn(double from, double to, int symmetry) {
  if (symmetry == 0) return 0;
  return std::remainder(to - from, 2 * kPi / symmetry);
}

void average(Match& match, const std::vector<Pose2D>& poses) {
  Pose2D mean = {0, 0, 0};
  int count = 0;
  for (const auto& pose : poses) {
    const double angle = turn(match.pose.theta, pose.theta, match.symmetry);
    if (std::abs(angle) > kSameAngle) continue;
    ++count;
    mean.x += pose.x;
    mean.y += pose.y;
    mean.theta += angle;
  }
  if (count == 0) return;
  match.pose = {mean.x / count, mean.y / count, wrap_angle(match.pose.theta + mean.theta / count)};
  match.covariance *= 1.0 / count;
}

}  // namespace

void PoseAverage::add(const std::vector<TrackedMatch>& matches) {
  for (const auto& tracked : matches)
    if (tracked.state != TrackState::kHeld)
      poses_[tracked.instance_id].push_back(tracked.match.pose);
}

void PoseAverage::apply(std::vector<TrackedMatch>& matches) const {
  for (auto& tracked : matches) {
    const auto poses = poses_.find(tracked.instance_id);
    if (poses != poses_.end()) average(tracked.match, poses->second);
  }
}

}  // namespace mbncc
