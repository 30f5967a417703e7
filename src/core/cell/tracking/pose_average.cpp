// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/pose_average.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mbncc {
namespace {

constexpr double kSameAngle = to_radians(15);
constexpr double kTrendFactor = 3;   // standard deviations of a significant trend
constexpr double kStatedWeight = 2;  // weight of the stated variance, in images
constexpr double kJumpFactor = 4;    // standard deviations of a significant jump
// Largest ratio of scatter to stated variance of a coordinate.
constexpr double kMostVarianceRatio = 2;
// [px], [px], [rad] Smaller motions are ignored, because the poses of noise-free images do not
// scatter at all.
const cv::Vec3d kLeastTrend(0.05, 0.05, to_radians(0.05));

cv::Vec3d values_of(const Pose2D& pose) {
  return {pose.x, pose.y, pose.theta};
}

cv::Vec3d mean_of(const std::deque<Pose2D>& poses, std::size_t from, std::size_t to) {
  cv::Vec3d sum;
  for (std::size_t i = from; i < to; ++i) sum += values_of(poses[i]);
  return sum / static_cast<double>(to - from);
}

/// Sum of squared second differences. A steady motion adds nothing to it; each difference adds on
/// average six times the variance of a single pose.
cv::Vec3d second_differences_of(const std::deque<Pose2D>& poses) {
  cv::Vec3d sum;
  for (std::size_t i = 2; i < poses.size(); ++i) {
    const cv::Vec3d bend =
        values_of(poses[i]) - 2 * values_of(poses[i - 1]) + values_of(poses[i - 2]);
    sum += bend.mul(bend);
  }
  return sum;
}

/// Variance of a single pose, estimated from the images.
cv::Vec3d scatter_of(const std::deque<Pose2D>& poses) {
  if (poses.size() > 2)
    return second_differences_of(poses) / (6.0 * static_cast<double>(poses.size() - 2));
  const cv::Vec3d step = values_of(poses.back()) - values_of(poses.front());
  return step.mul(step) / 2;
}

/// Whether the later half differs from the earlier one, relative to the scatter and the stated
/// variance.
bool has_trend(const std::deque<Pose2D>& poses, const cv::Matx33d& covariance) {
  const std::size_t count = poses.size(), half = count / 2;
  if (half == 0) return false;
  const cv::Vec3d trend = mean_of(poses, count - half, count) - mean_of(poses, 0, half);
  const cv::Vec3d bends = second_differences_of(poses);
  for (int i = 0; i < 3; ++i) {
    const double variance = (kStatedWeight * covariance(i, i) + bends[i] / 6) /
                            (kStatedWeight + static_cast<double>(count) - 2);
    const double deviation = std::sqrt(2 * variance / static_cast<double>(half));
    if (std::abs(trend[i]) > kLeastTrend[i] + kTrendFactor * deviation) return true;
  }
  return false;
}

/// Whether the newest pose is farther from the mean of the others than its covariance allows.
bool has_jumped(const std::deque<Pose2D>& poses, const cv::Matx33d& covariance) {
  if (poses.size() < 2) return false;
  const cv::Vec3d step = values_of(poses.back()) - mean_of(poses, 0, poses.size() - 1);
  for (int i = 0; i < 3; ++i)
    if (std::abs(step[i]) > kLeastTrend[i] + kJumpFactor * std::sqrt(covariance(i, i))) return true;
  return false;
}

/// Part of the covariance that remains after averaging `count` images: only what scatters from
/// image to image is averaged. The scatter is estimated from all three coordinates together.
double remaining_share(const cv::Matx33d& covariance, const cv::Vec3d& scatter, double count) {
  double random = 0;
  for (int i = 0; i < 3; ++i)
    if (covariance(i, i) > 0)
      random += std::min(kMostVarianceRatio, scatter[i] / covariance(i, i)) / 3;
  return std::max(0.0, 1 - random) + random / count;
}

/// The match at another pose nearby, with its outline.
void move_to(const Pose2D& pose, Match& match) {
  const Pose2D move = compose(pose, inverse(match.pose));
  for (auto& point : match.outline) point = transform(move, cv::Point2d(point));
  match.pose = pose;
}

}  // namespace

PoseAverage::PoseAverage(int most) : most_(static_cast<std::size_t>(most)) {
  if (most < 1) throw std::invalid_argument("an average needs at least one image");
}

void PoseAverage::apply(std::vector<TrackedMatch>& matches) {
  std::map<std::uint32_t, Poses> still;
  for (auto& tracked : matches) {
    Match& match = tracked.match;
    Poses& poses = still[tracked.instance_id] = std::move(still_[tracked.instance_id]);
    if (tracked.state != TrackState::kHeld && match.fresh) add(poses, match);
    if (poses.empty()) continue;
    const cv::Vec3d mean = mean_of(poses, 0, poses.size());
    move_to({mean[0], mean[1], wrap_angle(mean[2])}, match);
    match.covariance *=
        remaining_share(match.covariance, scatter_of(poses), static_cast<double>(poses.size()));
  }
  still_ = std::move(still);
}

void PoseAverage::add(Poses& poses, const Match& match) const {
  Pose2D pose = match.pose;
  if (!poses.empty()) {
    const double turn = std::remainder(pose.theta - poses.back().theta, 2 * kPi);
    if (std::abs(turn) > kSameAngle) poses.clear();
    if (!poses.empty()) pose.theta = poses.back().theta + turn;
  }
  poses.push_back(pose);
  if (poses.size() > most_) poses.pop_front();
  if (has_jumped(poses, match.covariance) || has_trend(poses, match.covariance))
    poses = {match.pose};
}

}  // namespace mbncc
