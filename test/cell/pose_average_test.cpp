#include "mbncc/cell/pose_average.hpp"

#include <gtest/gtest.h>

namespace mbncc {
namespace {

TrackedMatch seen(std::uint32_t id, const Pose2D& pose, int symmetry = 1) {
  TrackedMatch tracked;
  tracked.instance_id = id;
  tracked.match.pose = pose;
  tracked.match.symmetry = symmetry;
  tracked.match.covariance = cv::Matx33d::eye();
  return tracked;
}

TEST(PoseAverage, TakesTheMeanOfEachInstance) {
  PoseAverage average;
  average.add({seen(1, {10, 20, 0.1}), seen(2, {50, 60, 1})});
  average.add({seen(1, {12, 22, 0.2})});
  std::vector<TrackedMatch> matches{seen(1, {12, 22, 0.2}), seen(2, {50, 60, 1})};
  average.apply(matches);
  EXPECT_DOUBLE_EQ(matches[0].match.pose.x, 11);
  EXPECT_DOUBLE_EQ(matches[0].match.pose.y, 21);
  EXPECT_NEAR(matches[0].match.pose.theta, 0.15, 1e-12);
  EXPECT_DOUBLE_EQ(matches[0].match.covariance(0, 0), 0.5);
  EXPECT_DOUBLE_EQ(matches[1].match.pose.x, 50);
}

TEST(PoseAverage, BearsTheTurnFromPiToMinusPi) {
  PoseAverage average;
  average.add({seen(1, {0, 0, kPi - 0.01})});
  average.add({seen(1, {0, 0, -kPi + 0.01})});
  std::vector<TrackedMatch> matches{seen(1, {0, 0, -kPi + 0.01})};
  average.apply(matches);
  EXPECT_NEAR(angle_distance(matches[0].match.pose.theta, kPi), 0, 1e-12);
}

TEST(PoseAverage, LeavesOutAPoseOfAnotherAngle) {
  PoseAverage average;
  average.add({seen(1, {0, 0, 1})});
  average.add({seen(1, {4, 4, 0})});
  std::vector<TrackedMatch> matches{seen(1, {4, 4, 0})};
  average.apply(matches);
  EXPECT_DOUBLE_EQ(matches[0].match.pose.x, 4);
  EXPECT_DOUBLE_EQ(matches[0].match.covariance(0, 0), 1);
}

TEST(PoseAverage, CountsEqualPositionsOfASymmetricObjectAsOne) {
  PoseAverage average;
  average.add({seen(1, {0, 0, 0.1 + kPi}, 2)});
  average.add({seen(1, {2, 0, 0.1}, 2)});
  std::vector<TrackedMatch> matches{seen(1, {2, 0, 0.1}, 2)};
  average.apply(matches);
  EXPECT_DOUBLE_EQ(matches[0].match.pose.x, 1);
  EXPECT_NEAR(matches[0].match.pose.theta, 0.1, 1e-12);
}

TEST(PoseAverage, IgnoresHeldInstancesAndUnknownOnes) {
  PoseAverage average;
  TrackedMatch held = seen(1, {9, 9, 0});
  held.state = TrackState::kHeld;
  average.add({held});
  std::vector<TrackedMatch> matches{seen(1, {1, 2, 0}), seen(7, {3, 4, 0})};
  average.apply(matches);
  EXPECT_DOUBLE_EQ(matches[0].match.pose.x, 1);
  EXPECT_DOUBLE_EQ(matches[1].match.pose.x, 3);
}

}  // namespace
}  // namespace mbncc
