// When a tracked instance is confirmed or ambiguous, and what its angle does.
#include <gtest/gtest.h>

#include <cmath>

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

TEST(InstanceTracker, MissedPicturesCountAgainstConfirmation) {
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

TEST(InstanceTracker, AngleJumpHasToBeConfirmedAnew) {
  InstanceTracker tracker;
  for (int i = 0; i < 5; ++i) tracker.update(i, {match_at(100, 100, 0)});
  const auto flipped = tracker.update(5, {match_at(100, 100, kPi)});
  EXPECT_EQ(flipped[0].instance_id, 1u);
  EXPECT_EQ(flipped[0].state, TrackState::kNew);
  tracker.update(6, {match_at(100, 100, -kPi)});
  EXPECT_EQ(tracker.update(7, {match_at(100, 100, kPi)})[0].state, TrackState::kConfirmed);
}

TEST(InstanceTracker, AngleJumpByTheSymmetryIsNone) {
  InstanceTracker tracker;
  for (int i = 0; i < 6; ++i) {
    Match match = match_at(100, 100, i % 2 == 0 ? 0 : kPi);
    match.symmetry = 2;
    EXPECT_EQ(tracker.update(i, {match})[0].state == TrackState::kConfirmed, i >= 2);
  }
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

}  // namespace
}  // namespace mbncc
