// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/pose_average.hpp"

#include <gtest/gtest.h>

namespace mbncc {
namespace {

constexpr double kSigma = 0.2;         // [px]
constexpr double kSigmaAngle = 0.002;  // [rad]

TrackedMatch seen(std::uint32_t id, const Pose2D& pose) {
  TrackedMatch tracked;
  tracked.instance_id = id;
  tracked.state = TrackState::kConfirmed;
  tracked.match.pose = pose;
  tracked.match.outline = {cv::Point2f(transform(pose, {30, 0}))};
  tracked.match.covariance =
      cv::Matx33d::diag({kSigma * kSigma, kSigma * kSigma, kSigmaAngle * kSigmaAngle});
  return tracked;
}

Pose2D noisy(const Pose2D& pose, cv::RNG& random) {
  return {pose.x + random.gaussian(kSigma), pose.y + random.gaussian(kSigma),
          wrap_angle(pose.theta + random.gaussian(kSigmaAngle))};
}

/// The tracked instance after one more image in which it has this pose.
Match averaged(PoseAverage& average, const Pose2D& pose, std::uint32_t id = 1) {
  std::vector<TrackedMatch> matches{seen(id, pose)};
  average.apply(matches);
  return matches[0].match;
}

TEST(PoseAverage, NormalisedErrorOfStillInstancesIsAboutOne) {
  cv::RNG random(7);
  double sum = 0, error = 0;
  constexpr int kTrials = 400, kImages = 10;
  for (int trial = 0; trial < kTrials; ++trial) {
    PoseAverage average(kImages);
    const Pose2D truth{100, 50, kPi - 0.001};
    Match last;
    for (int i = 0; i < kImages; ++i) last = averaged(average, noisy(truth, random));
    sum += std::pow(last.pose.x - truth.x, 2) / last.covariance(0, 0);
    error += std::pow(last.pose.x - truth.x, 2);
    EXPECT_LT(angle_distance(last.pose.theta, truth.theta), 5 * kSigmaAngle);
  }
  EXPECT_NEAR(std::sqrt(sum / kTrials), 1, 0.3);
  EXPECT_LT(std::sqrt(error / kTrials), 0.6 * kSigma);
}

TEST(PoseAverage, PosesThatScatterMoreThanStatedAreNotStatedTooPrecisely) {
  cv::RNG random(9);
  double sum = 0;
  constexpr int kTrials = 400;
  constexpr double kMore = 1.35;
  for (int trial = 0; trial < kTrials; ++trial) {
    PoseAverage average(10);
    const Pose2D truth{100, 50, 1};
    Match last;
    for (int i = 0; i < 10; ++i) {
      const Pose2D usual = noisy(truth, random);
      last = averaged(average,
                      {truth.x + kMore * (usual.x - truth.x), truth.y + kMore * (usual.y - truth.y),
                       truth.theta + kMore * (usual.theta - truth.theta)});
    }
    sum += std::pow(last.pose.x - truth.x, 2) / last.covariance(0, 0);
  }
  EXPECT_LT(std::sqrt(sum / kTrials), 1.3);
}

TEST(PoseAverage, CommonErrorOfAllImagesStaysInTheCovariance) {
  PoseAverage average(10);
  Match last;
  for (int i = 0; i < 10; ++i) last = averaged(average, {100, 50, 1});
  EXPECT_NEAR(last.covariance(0, 0), kSigma * kSigma, 1e-9);
}

TEST(PoseAverage, AMovingInstanceDoesNotLagBehind) {
  for (const double speed : {0.05, 0.2, 1.0, 5.0}) {
    cv::RNG random(3);
    PoseAverage average(10);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
      const Pose2D truth{100 + speed * i, 50, 0};
      worst = std::max(worst, std::abs(averaged(average, noisy(truth, random)).pose.x - truth.x));
    }
    EXPECT_LT(worst, 5 * kSigma) << speed;
  }
}

// The motion is too slow for a jump between images, but a mean of ten would lag behind by half of
// their path.
TEST(PoseAverage, ACreepingInstanceDoesNotLagBehind) {
  PoseAverage average(10);
  for (int i = 0; i < 40; ++i)
    EXPECT_LT(std::abs(averaged(average, {100 + 0.1 * i, 50, 0}).pose.x - (100 + 0.1 * i)), 0.35);
}

TEST(PoseAverage, AChangedAngleRestartsTheAverageAtAnyCovariance) {
  PoseAverage average(10);
  Match last;
  for (const double degrees : {0, 0, 20}) {
    std::vector<TrackedMatch> matches{seen(1, {100, 50, to_radians(degrees)})};
    matches[0].match.covariance(2, 2) = 0.01;
    average.apply(matches);
    last = matches[0].match;
  }
  EXPECT_NEAR(last.pose.theta, to_radians(20), 1e-12);
}

TEST(PoseAverage, InstancesNotFoundInThisImageAddNothing) {
  PoseAverage average(10);
  averaged(average, {10, 20, 0});
  averaged(average, {10.2, 20, 0});
  std::vector<TrackedMatch> matches{seen(1, {10.2, 20, 0})};
  matches[0].match.fresh = false;
  average.apply(matches);
  EXPECT_NEAR(matches[0].match.pose.x, 10.1, 1e-9);
}

TEST(PoseAverage, ASuddenMoveOrTurnRestartsTheAverage) {
  PoseAverage average(10);
  for (int i = 0; i < 10; ++i) averaged(average, {100, 50, 0});
  EXPECT_DOUBLE_EQ(averaged(average, {104, 50, 0}).pose.x, 104);
  EXPECT_NEAR(averaged(average, {104, 50, 1}).pose.theta, 1, 1e-12);
}

TEST(PoseAverage, HandlesTheWrapFromPiToMinusPi) {
  PoseAverage average(10);
  averaged(average, {0, 0, kPi - 0.001});
  EXPECT_NEAR(angle_distance(averaged(average, {0, 0, -kPi + 0.001}).pose.theta, kPi), 0, 1e-9);
}

TEST(PoseAverage, OutlineMovesWithThePose) {
  PoseAverage average(10);
  averaged(average, {10, 20, 0.001});
  const Match match = averaged(average, {10.2, 20, 0.002});
  EXPECT_NEAR(match.pose.x, 10.1, 1e-9);
  EXPECT_LT(cv::norm(cv::Point2d(match.outline[0]) - transform(match.pose, {30, 0})), 1e-4);
}

TEST(PoseAverage, HeldInstancesKeepTheirMeanAndMissingOnesLoseIt) {
  PoseAverage average(10);
  averaged(average, {10, 20, 0});
  averaged(average, {10.2, 20, 0});
  std::vector<TrackedMatch> matches{seen(1, {10.2, 20, 0})};
  matches[0].state = TrackState::kHeld;
  average.apply(matches);
  EXPECT_NEAR(matches[0].match.pose.x, 10.1, 1e-9);
  averaged(average, {0, 0, 0}, 2);
  EXPECT_DOUBLE_EQ(averaged(average, {10.2, 20, 0}).pose.x, 10.2);
}

TEST(PoseAverage, AWindowOfOneImageReturnsThatImage) {
  PoseAverage average(1);
  averaged(average, {10, 20, 0});
  EXPECT_DOUBLE_EQ(averaged(average, {10.1, 20, 0}).pose.x, 10.1);
  EXPECT_THROW(PoseAverage(0), std::invalid_argument);
}

}  // namespace
}  // namespace mbncc
