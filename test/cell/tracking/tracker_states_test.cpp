// SPDX-License-Identifier: BSD-3-Clause
// Confirmation and ambiguity of tracked instances, and their angles.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "cell/tracked_matches.hpp"
#include "mbncc/cell/tracker.hpp"

namespace mbncc {
namespace {

TEST(InstanceTracker, ConfirmsByKOfN) {
  InstanceTracker tracker;
  const bool graspable[] = {true, false, true, false, true, true, false, false, false, true};
  const bool confirmed[] = {false, false, false, false, true, true, false, false, false, false};
  for (int i = 0; i < 10; ++i) {
    Match match = match_at(100, 100);
    match.graspable = graspable[i];
    const auto tracked = tracker.update(i, {match});
    EXPECT_EQ(tracked[0].state == TrackState::kConfirmed, confirmed[i]) << i;
  }
}

TEST(InstanceTracker, MissedImagesCountAgainstConfirmation) {
  InstanceTracker tracker;
  for (int i = 0; i < 4; ++i) tracker.update(i, {match_at(100, 100)});
  for (int i = 4; i < 7; ++i) EXPECT_TRUE(tracker.update(i, {}).empty());
  EXPECT_EQ(tracker.update(7, {match_at(100, 100)})[0].state, TrackState::kNew);
  EXPECT_EQ(tracker.update(8, {match_at(100, 100)})[0].instance_id, 1u);
}

TEST(InstanceTracker, AmbiguousIsNeverConfirmed) {
  InstanceTracker tracker;
  for (int i = 0; i < 4; ++i) tracker.update(i, {match_at(100, 100)});
  EXPECT_EQ(tracker.update(4, {ambiguous_at(100, 100)})[0].state, TrackState::kAmbiguous);
}

TEST(InstanceTracker, AnAngleJumpMustBeConfirmedAgain) {
  InstanceTracker tracker;
  for (int i = 0; i < 5; ++i) tracker.update(i, {match_at(100, 100, 0)});
  const auto flipped = tracker.update(5, {match_at(100, 100, kPi)});
  EXPECT_EQ(flipped[0].instance_id, 1u);
  EXPECT_EQ(flipped[0].state, TrackState::kNew);
  tracker.update(6, {match_at(100, 100, -kPi)});
  EXPECT_EQ(tracker.update(7, {match_at(100, 100, kPi)})[0].state, TrackState::kConfirmed);
}

TEST(InstanceTracker, ATurnOfThreeDegreesIsAnotherAngle) {
  for (const double degrees : {2, 4}) {
    InstanceTracker tracker;
    for (int i = 0; i < 5; ++i) tracker.update(i, {match_at(100, 100, 0)});
    EXPECT_EQ(tracker.update(5, {match_at(100, 100, to_radians(degrees))})[0].state,
              degrees < 3 ? TrackState::kConfirmed : TrackState::kNew);
  }
}

TEST(InstanceTracker, ARotationByTheSymmetryIsNoAngleJump) {
  InstanceTracker tracker;
  for (int i = 0; i < 6; ++i) {
    Match match = match_at(100, 100, i % 2 == 0 ? 0 : kPi);
    match.symmetry = 2;
    EXPECT_EQ(tracker.update(i, {match})[0].state == TrackState::kConfirmed, i >= 2);
  }
}

// The reference point lies 15 px off the centre of symmetry, so it moves when the angle does.
TEST(InstanceTracker, AnEquivalentPoseIsTurnedAboutTheCentreOfSymmetry) {
  InstanceTracker tracker;
  const cv::Point2d centre(100, 100);
  const auto seen_turned = [&](double theta) {
    Match match = match_at(0, 0, theta);
    match.symmetry = 2;
    match.to_symmetry_centre = rotate({-15, 0}, theta);
    match.pose.x = centre.x - match.to_symmetry_centre.x;
    match.pose.y = centre.y - match.to_symmetry_centre.y;
    match.covariance = cv::Matx33d::diag({0.01, 0.01, 1e-4});
    return match;
  };
  tracker.update(0, {seen_turned(0.7)});
  const auto tracked = tracker.update(0.1, {seen_turned(0.7 + kPi)});
  EXPECT_EQ(tracked[0].instance_id, 1u);
  const Match& match = tracked[0].match;
  const Match first = seen_turned(0.7);
  EXPECT_NEAR(match.pose.theta, 0.7, 1e-9);
  EXPECT_NEAR(match.pose.x, first.pose.x, 1e-9);
  EXPECT_NEAR(match.pose.y, first.pose.y, 1e-9);
  // The uncertain angle displaces the turned reference point by twice the lever.
  EXPECT_NEAR(match.covariance(0, 0) + match.covariance(1, 1), 0.02 + 1e-4 * 30 * 30, 1e-9);
}

TEST(InstanceTracker, EqualAnglesOfASymmetricObjectStayNearTheLast) {
  InstanceTracker tracker;
  cv::RNG random(4);
  double last = 0.1;
  for (int i = 0; i < 50; ++i) {
    Match match = match_at(100, 100, 0.1 + 0.1 * i + random.uniform(0, 3) * 2 * kPi / 3);
    match.symmetry = 3;
    const double theta = tracker.update(i, {match})[0].match.pose.theta;
    if (i == 0) last = theta - 0.1;
    EXPECT_NEAR(std::remainder(theta - last, 2 * kPi), 0.1, 1e-9) << i;
    last = theta;
  }
}

TEST(InstanceTracker, RoundObjectsDoNotTurn) {
  InstanceTracker tracker;
  for (int i = 0; i < 5; ++i) {
    Match match = match_at(100, 100, 0.3 + i);
    match.symmetry = 0;
    EXPECT_NEAR(tracker.update(i, {match})[0].match.pose.theta, 0.3, 1e-12);
  }
}

TEST(InstanceTracker, ReportsWhyAnInstanceIsNotConfirmed) {
  InstanceTracker tracker({3, 5, 10, 0.5, 10});
  EXPECT_EQ(tracker.update(0, {match_at(100, 100)})[0].reasons,
            std::vector<std::string>{"graspable in 1 of the last 5 images, 3 needed"});
  tracker.update(1, {match_at(100, 100)});
  EXPECT_TRUE(tracker.update(2, {match_at(100, 100)})[0].reasons.empty());
  Match doubtful = ambiguous_at(100, 100);
  doubtful.reasons = {"angle open"};
  EXPECT_EQ(tracker.update(3, {doubtful})[0].reasons, doubtful.reasons);
  const auto held = tracker.update(4, {});
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held[0].reasons, std::vector<std::string>{"not seen in this image"});
}

TEST(InstanceTracker, AfterAnInterruptionInstancesAreConfirmedAgain) {
  InstanceTracker tracker;
  for (int i = 0; i < 5; ++i) tracker.update(i, {match_at(100, 100)});
  tracker.interrupt();
  for (int i = 5; i < 8; ++i) {
    const auto tracked = tracker.update(i, {match_at(100, 100)});
    EXPECT_EQ(tracked[0].instance_id, 1u);
    EXPECT_EQ(tracked[0].frame_index, 0);
    EXPECT_EQ(tracked[0].state == TrackState::kConfirmed, i == 7) << i;
  }
}

class BestInstance : public ::testing::Test {
 protected:
  /// x of the instance that the stable frame follows; 0 if there is none.
  double best_of(const std::vector<Match>& matches) {
    double x = 0;
    for (const auto& tracked : tracker_.update(now_++, matches)) {
      if (!tracked.is_best) continue;
      EXPECT_EQ(tracked.state, TrackState::kConfirmed);
      EXPECT_EQ(x, 0) << "one of a name";
      x = tracked.match.pose.x;
    }
    return x;
  }

  static Match scored(double x, double score) {
    Match match = match_at(x, 100);
    match.score = score;
    return match;
  }

  InstanceTracker tracker_;
  double now_ = 0;
};

TEST_F(BestInstance, IsTheOneWithTheBestScoreOnceConfirmed) {
  for (int i = 0; i < 2; ++i) EXPECT_EQ(best_of({scored(100, 0.9), scored(300, 0.95)}), 0);
  EXPECT_EQ(best_of({scored(100, 0.9), scored(300, 0.95)}), 300);
}

TEST_F(BestInstance, StaysWhileItIsConfirmed) {
  for (int i = 0; i < 3; ++i) best_of({scored(100, 0.9), scored(300, 0.95)});
  EXPECT_EQ(best_of({scored(300, 0.85), scored(100, 0.99)}), 300);
  EXPECT_EQ(best_of({scored(100, 0.99), ambiguous_at(300, 100)}), 100);
  EXPECT_EQ(best_of({scored(100, 0.9), scored(300, 0.99)}), 100) << "it does not go back";
}

}  // namespace
}  // namespace mbncc
