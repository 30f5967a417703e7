// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/tracker.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "cell/tracked_matches.hpp"

namespace mbncc {
namespace {

TEST(InstanceTracker, KeepsTheIdentityOfASlowlyMovingInstance) {
  InstanceTracker tracker;
  for (int i = 0; i < 20; ++i) {
    const auto tracked = tracker.update(i * 0.1, {match_at(100 + 10 * i, 80, 0.05 * i)});
    ASSERT_EQ(tracked.size(), 1u);
    EXPECT_EQ(tracked[0].instance_id, 1u);
    EXPECT_EQ(tracked[0].frame_index, 0);
    EXPECT_EQ(tracked[0].state, i < 2 ? TrackState::kNew : TrackState::kConfirmed);
  }
}

Match seen_at(double x, double theta, double deviation = 0.1) {
  Match match = match_at(x, 100, theta);
  const double variance = deviation * deviation;
  match.covariance = cv::Matx33d::diag({variance, variance, variance / 3600});
  return match;
}

// [px/s], [degrees/s] at 30 Hz
TEST(InstanceTracker, APoseIsValidUntilTheInstanceHasMoved) {
  for (const double speed : {0., 2., 5., 20., 90., 500.})
    for (const double rotation : {0., 20., 60.}) {
      InstanceTracker tracker;
      for (int i = 0; i < 30; ++i) {
        const double stamp = i / 30.;
        const auto tracked =
            tracker.update(stamp, {seen_at(100 + speed * stamp, to_radians(rotation) * stamp)});
        EXPECT_EQ(tracked[0].instance_id, 1u);
        const double valid = tracked[0].valid_until - stamp;
        EXPECT_GE(valid, 0);
        EXPECT_LE(valid, 0.5 + 1e-9);
        if (i < 2) continue;  // not yet confirmed
        EXPECT_LE(valid * speed, 4 + 1e-9);
        EXPECT_LE(valid * rotation, 3.5);
        if (i < 15) continue;
        if (speed <= 2 && rotation == 0) {
          EXPECT_NEAR(valid, 0.5, 1e-9);
        }
        if (speed > 2) {
          EXPECT_GE(valid * std::max(speed / 2, rotation / 1.5), 0.9);
        }
      }
    }
}

TEST(InstanceTracker, AnInstanceThatHasStoppedIsValidForMaxAgeAfterHalfASecond) {
  InstanceTracker tracker;
  for (int i = 0; i < 60; ++i) {
    const double stamp = i / 30.;
    const auto tracked = tracker.update(stamp, {seen_at(100 + 3 * std::min(i, 20), 0)});
    const double valid = tracked[0].valid_until - stamp;
    if (i > 0 && i < 20 + 10) {
      EXPECT_LT(valid, 0.3) << i;
    }
    if (i > 20 + 15) {
      EXPECT_NEAR(valid, 0.5, 1e-9) << i;
    }
  }
}

TEST(InstanceTracker, WhatTheCovariancesExplainIsNoMotion) {
  const auto valid_after = [](double way, double turn, double deviation) {
    InstanceTracker tracker;
    for (const double stamp : {0., 0.3}) tracker.update(stamp, {seen_at(100, 0, deviation)});
    return tracker.update(0.4, {seen_at(100 + way, to_radians(turn), deviation)})[0].valid_until -
           0.4;
  };
  EXPECT_NEAR(valid_after(0.9, 0, 0.05), 0.5, 1e-9);
  EXPECT_LT(valid_after(2, 0, 0.05), 0.3);
  EXPECT_NEAR(valid_after(4, 0, 1), 0.5, 1e-9);
  EXPECT_LT(valid_after(10, 0, 1), 0.1);
  EXPECT_NEAR(valid_after(0, 0.7, 0.05), 0.5, 1e-9);
  EXPECT_LT(valid_after(0, 1.5, 0.05), 0.3);
}

TEST(InstanceTracker, ANewInstanceIsValidForTwiceAsLongAsItHasBeenObserved) {
  InstanceTracker tracker;
  for (int i = 0; i < 10; ++i) {
    const double stamp = 0.05 * i;
    const auto tracked = tracker.update(stamp, {seen_at(100, 0)});
    const double valid = i == 0 ? 0.5 : std::min(0.5, 2 * stamp);
    EXPECT_NEAR(tracked[0].valid_until - stamp, valid, 1e-9) << i;
  }
}

TEST(InstanceTracker, TheLastTwoSightingsAreComparedHoweverFarApart) {
  InstanceTracker tracker;
  tracker.update(0, {seen_at(100, 0)});
  EXPECT_LT(tracker.update(2, {seen_at(110, 0)})[0].valid_until, 2.5);
}

TEST(InstanceTracker, AnswersInTheOrderOfTheMatches) {
  InstanceTracker tracker;
  tracker.update(0, {match_at(100, 100), match_at(300, 100)});
  const auto tracked = tracker.update(1, {match_at(301, 100), match_at(101, 100)});
  ASSERT_EQ(tracked.size(), 2u);
  EXPECT_EQ(tracked[0].instance_id, 2u);
  EXPECT_EQ(tracked[0].frame_index, 1);
  EXPECT_EQ(tracked[0].match.pose.x, 301);
  EXPECT_EQ(tracked[1].instance_id, 1u);
}

TEST(InstanceTracker, AJumpBeyondTheGateStartsAnotherInstanceAndFrame) {
  InstanceTracker tracker;
  tracker.update(0, {match_at(100, 100)});
  const auto tracked = tracker.update(0.1, {match_at(200, 100)});
  ASSERT_EQ(tracked.size(), 1u);
  EXPECT_EQ(tracked[0].instance_id, 2u);
  EXPECT_EQ(tracked[0].frame_index, 1);
  EXPECT_EQ(tracked[0].state, TrackState::kNew);
}

TEST(InstanceTracker, MotionIsExtrapolatedForHalfASecondOnly) {
  for (const double pause : {0.4, 0.8}) {
    InstanceTracker tracker;
    tracker.update(0, {match_at(100, 100)});
    tracker.update(0.1, {match_at(110, 100)});
    const auto later = tracker.update(0.1 + pause, {match_at(110 + 100 * pause, 100)});
    EXPECT_EQ(later[0].instance_id, pause < 0.5 ? 1u : 2u) << pause;
  }
}

TEST(InstanceTracker, NearestMatchesAreAssociated) {
  InstanceTracker tracker;
  tracker.update(0, {match_at(100, 100), match_at(108, 100)});
  const auto tracked = tracker.update(0.1, {match_at(107, 100), match_at(99, 100)});
  EXPECT_EQ(tracked[0].instance_id, 2u);
  EXPECT_EQ(tracked[1].instance_id, 1u);
}

TEST(InstanceTracker, NamesAndRevisionsAreKeptApart) {
  InstanceTracker tracker;
  tracker.update(0, {match_at(100, 100)});
  EXPECT_EQ(tracker.update(1, {match_at(100, 100, 0, "nut")})[0].instance_id, 2u);
  EXPECT_EQ(tracker.update(2, {match_at(100, 100, 0, "nut")})[0].frame_index, 0);
  Match relearned = match_at(100, 100);
  relearned.revision = 2;
  EXPECT_EQ(tracker.update(3, {relearned})[0].instance_id, 3u);
}

TEST(InstanceTracker, AnInstanceMissedInAWholeWindowIsForgotten) {
  const int window = TrackerConfig().confirm_window;
  for (const int missed : {window - 1, window}) {
    InstanceTracker tracker;
    tracker.update(0, {match_at(100, 100)});
    for (int i = 1; i <= missed; ++i) tracker.update(0.01 * i, {});
    EXPECT_EQ(tracker.update(0.1, {match_at(100, 100)})[0].instance_id, missed < window ? 1u : 2u);
  }
}

TEST(InstanceTracker, AFrameIndexIsNotReusedForTenSeconds) {
  InstanceTracker tracker;
  double stamp = 0;
  tracker.update(stamp, {match_at(100, 100)});
  for (int i = 0; i < 6; ++i) tracker.update(stamp += 0.1, {});
  const double lost_at = stamp;
  EXPECT_EQ(tracker.update(lost_at + 9.9, {match_at(300, 100)})[0].frame_index, 1);
  EXPECT_EQ(tracker.update(lost_at + 10.1, {match_at(300, 100), match_at(100, 100)})[1].frame_index,
            0);
}

TEST(InstanceTracker, AResetFreesFrameIndicesOnlyIfTheClockHasJumpedBack) {
  InstanceTracker tracker;
  tracker.update(1, {match_at(100, 100)});
  tracker.reset();
  EXPECT_EQ(tracker.update(1.1, {match_at(300, 100)})[0].frame_index, 1);
  EXPECT_EQ(tracker.update(0.5, {match_at(300, 100)})[0].frame_index, 0);
}

TEST(InstanceTracker, IdsAreNeverUsedAgain) {
  InstanceTracker tracker;
  cv::RNG random(3);
  std::set<std::uint32_t> closed, open;
  for (int i = 0; i < 500; ++i) {
    std::vector<Match> matches;
    for (int k = random.uniform(0, 4); k > 0; --k)
      matches.push_back(match_at(random.uniform(0, 5) * 100, random.uniform(0, 5) * 100));
    std::set<std::uint32_t> now;
    std::set<int> frames;
    const auto tracked = tracker.update(i * 0.2, matches);
    for (const auto& instance : tracked) {
      EXPECT_TRUE(now.insert(instance.instance_id).second) << "one match per instance";
      EXPECT_TRUE(frames.insert(instance.frame_index).second) << "one instance per frame";
    }
    if (i % 50 == 49) {
      tracker.reset();
      closed.insert(open.begin(), open.end());
      closed.insert(now.begin(), now.end());
      open.clear();
    } else {
      open.insert(now.begin(), now.end());
    }
    for (const auto id : now) EXPECT_TRUE(i % 50 == 49 || closed.count(id) == 0);
  }
}

/// Two equal objects that pass each other repeatedly at a distance of one width, each at 5 px per
/// image.
class Passing {
 public:
  explicit Passing(std::uint64_t seed) : random_(seed) {}

  /// In a fifth of the cases, the whole image is dropped, or else one object is missed.
  void run(int images, bool whole) {
    for (int i = 0; i < images; ++i) {
      const double way = 5 * std::abs((i % 120) - 60);  // there and back
      std::vector<Match> matches;
      std::vector<int> objects;
      const bool dropped = random_.uniform(0., 1.) < 0.2;
      for (const int object : {0, 1}) {
        if (!whole && random_.uniform(0., 1.) < 0.2) continue;
        matches.push_back(seen_at(object == 0 ? 100 + way : 400 - way, 100 + 80 * object));
        objects.push_back(object);
      }
      if (!(whole && dropped)) check(tracker_.update(i / 30.0, matches), objects);
    }
  }

  int swaps = 0, renewals = 0;

 private:
  Match seen_at(double x, double y) {
    return match_at(x + random_.gaussian(0.3), y + random_.gaussian(0.3));
  }

  void check(const std::vector<TrackedMatch>& tracked, const std::vector<int>& objects) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const auto [owner, is_new] = owners_.emplace(tracked[i].instance_id, objects[i]);
      renewals += is_new ? 1 : 0;
      swaps += owner->second != objects[i] ? 1 : 0;
    }
  }

  cv::RNG random_;
  InstanceTracker tracker_;
  std::map<std::uint32_t, int> owners_;
};

TEST(InstanceTracker, NeverSwapsEqualObjectsThatPassEachOther) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
    for (const bool whole : {true, false}) {
      Passing passing(seed);
      passing.run(300, whole);
      EXPECT_EQ(passing.swaps, 0) << seed;
      EXPECT_LE(passing.renewals, 5) << "two objects, two identities";
    }
}

TEST(InstanceTracker, HoldsALostInstanceForTheHoldTime) {
  TrackerConfig config;
  config.hold_time = 1;
  InstanceTracker tracker(config);
  for (int i = 0; i < 4; ++i) tracker.update(0.1 * i, {match_at(100, 100)});
  const auto held = tracker.update(1.2, {});
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held[0].state, TrackState::kHeld);
  EXPECT_DOUBLE_EQ(held[0].valid_until, 0.3 + 0.5) << "counts from when it was seen";
  EXPECT_TRUE(tracker.update(1.4, {}).empty());
}

TEST(InstanceTracker, NothingIsHeldByDefault) {
  InstanceTracker tracker;
  tracker.update(0, {match_at(100, 100)});
  EXPECT_TRUE(tracker.update(0, {}).empty());
  EXPECT_TRUE(tracker.update(0.01, {}).empty());
}

TEST(InstanceTracker, ClockJumpBackResets) {
  InstanceTracker tracker;
  for (int i = 0; i < 5; ++i) tracker.update(100 + i, {match_at(100, 100)});
  const auto tracked = tracker.update(3, {match_at(100, 100)});
  EXPECT_EQ(tracked[0].instance_id, 2u);
  EXPECT_EQ(tracked[0].frame_index, 0);
  EXPECT_EQ(tracked[0].state, TrackState::kNew);
}

TEST(InstanceTracker, RefusesInvalidSettings) {
  TrackerConfig config;
  config.confirm_frames = 6;
  EXPECT_THROW(InstanceTracker{config}, std::invalid_argument);
  config.confirm_frames = 0;
  EXPECT_THROW(InstanceTracker{config}, std::invalid_argument);
  config = {};
  config.hold_time = -1;
  EXPECT_THROW(InstanceTracker{config}, std::invalid_argument);
}

}  // namespace
}  // namespace mbncc
