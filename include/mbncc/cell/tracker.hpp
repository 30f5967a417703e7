// SPDX-License-Identifier: BSD-3-Clause
// Gives the matches of successive pictures an identity: which instance is which, and which have
// been seen often enough to be gripped.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "mbncc/matching/matcher.hpp"

namespace mbncc {

struct TrackerConfig {
  int confirm_frames = 3;   ///< graspable pictures needed ...
  int confirm_window = 5;   ///< ... among this many of the last ones
  double hold_time = 0;     ///< [s] a lost instance is repeated as HELD; 0: not at all
  double max_age = 0.5;     ///< [s] that a pose stays valid
  double reuse_after = 10;  ///< [s] a lost instance's frame index is not given to another one
};

/// The numbers are those of msg/DetectedObject.msg.
enum class TrackState : std::uint8_t { kNew = 0, kConfirmed = 1, kAmbiguous = 2, kHeld = 3 };

/// An instance in the present picture.
struct TrackedMatch {
  Match match;
  std::uint32_t instance_id = 0;  ///< from 1, never used again
  int frame_index = 0;            ///< k of the tf frame object_<name>_<k>
  TrackState state = TrackState::kNew;
  /// The one confirmed instance of its name that the tf frame object_<name> follows: it stays the
  /// same until it is confirmed no more, then it is the one with the best score.
  bool is_best = false;
  double valid_until = 0;            ///< [s] stamp of the picture it was seen in plus max_age
  std::vector<std::string> reasons;  ///< why it is not confirmed; empty when it is
};

/// A match continues the nearest instance of its name and revision, if that is near enough for the
/// object to be the same: within half of its outline's radius of where the instance was seen last,
/// or of where it would be had it gone on moving. When the angle jumps by more than 3 degrees,
/// symmetry aside, the instance stays and has to be confirmed anew. Among the equal angles of a
/// symmetric object the one nearest to the last is taken; a round one keeps its first.
class InstanceTracker {
 public:
  /// Throws std::invalid_argument when confirm_frames is not in 1 .. confirm_window or a time is
  /// negative.
  explicit InstanceTracker(TrackerConfig config = {});

  /// Changes what confirms; throws as the constructor does, and changes nothing then. What was seen
  /// before is judged by it from the next picture on.
  void configure(const TrackerConfig& config);

  /// Takes the matches of the picture stamped `stamp` [s], all names searched. Returns them in
  /// their order, then the held instances. A stamp before the last one resets first.
  std::vector<TrackedMatch> update(double stamp, const std::vector<Match>& matches);

  /// Every instance has to be confirmed anew; one that has not moved keeps its id and frame.
  void interrupt();

  /// Forgets all instances; ids are not used again all the same.
  void reset();

 private:
  struct Track {
    TrackedMatch last;
    double seen_at = 0;          // [s]
    cv::Point2d velocity;        // [px/s] between the last two sightings
    std::deque<bool> graspable;  // of the last pictures, newest last
    int missed = 0;              // pictures in a row
    bool seen = false;           // in the present picture

    double distance_to(const Match& match, double stamp) const;
  };
  struct ReleasedFrame {
    std::string name;
    int index;
    double at;  // [s]
  };

  std::vector<Track*> associate(double stamp, const std::vector<Match>& matches);
  Track& begin_track(double stamp, const Match& match);
  void see(Track& track, const Match& match, double stamp);
  void note_missed();
  void choose_best(std::vector<TrackedMatch>& tracked);
  std::vector<std::string> reasons_of(const Track& track) const;
  bool is_held(const Track& track, double stamp) const;
  void drop_lost(double stamp);
  int free_frame_index(const std::string& name) const;
  bool is_frame_taken(const std::string& name, int index) const;

  TrackerConfig config_;
  std::deque<Track> tracks_;  // begin_track() keeps references valid
  std::vector<ReleasedFrame> released_;
  std::map<std::string, std::uint32_t> best_;  // instance by name
  std::uint32_t next_id_ = 1;
  double last_stamp_ = 0;
};

}  // namespace mbncc
