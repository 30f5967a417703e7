// SPDX-License-Identifier: BSD-3-Clause
// Tracks matches across images: assigns instance ids and confirms instances that were graspable
// often enough.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "mbncc/matching/match.hpp"

namespace mbncc {

struct TrackerConfig {
  int confirm_frames = 3;   ///< graspable images needed ...
  int confirm_window = 5;   ///< ... among this many of the last ones
  double hold_time = 0;     ///< [s] for which a lost instance is published as HELD; 0: never
  double max_age = 0.5;     ///< [s] that a pose stays valid, at most
  double reuse_after = 10;  ///< [s] for which a lost instance's frame index is not reused
};

/// The numbers are those of msg/DetectedObject.msg.
enum class TrackState : std::uint8_t { kNew = 0, kConfirmed = 1, kAmbiguous = 2, kHeld = 3 };

/// An instance in the current image.
struct TrackedMatch {
  Match match;
  std::uint32_t instance_id = 0;  ///< from 1, never used again
  int frame_index = 0;            ///< k of the tf frame object_<name>_<k>
  TrackState state = TrackState::kNew;
  /// The confirmed instance of its name that the tf frame object_<name> follows: the same one until
  /// it is no longer confirmed, then the one with the best score.
  bool is_best = false;
  double seen_at = 0;  ///< [s] stamp of the image it was detected in
  /// [s] seen_at plus max_age; earlier if it moves (when it is expected to have moved by 2 px
  /// or 1.5 degrees) or has been observed for less than half of max_age.
  double valid_until = 0;
  std::vector<std::string> reasons;  ///< why it is not confirmed; empty when it is
};

/// A match is assigned to the nearest instance of its name and revision, within half of its
/// outline's radius of the instance's last or extrapolated position. If the angle jumps by more
/// than 3 degrees (modulo symmetry), the instance continues but must be confirmed again. Of the
/// equivalent poses of a symmetric object, the one whose angle is nearest to the last is reported;
/// a round object keeps its first angle. An instance is lost when it has been missed in
/// confirm_window images in a row and is not held.
class InstanceTracker {
 public:
  /// Throws std::invalid_argument when confirm_frames is not in 1 .. confirm_window or a time is
  /// negative.
  explicit InstanceTracker(TrackerConfig config = {});

  /// Changes the settings. Throws like the constructor and then changes nothing. Earlier images
  /// are evaluated with the new settings from the next image on.
  void configure(const TrackerConfig& config);

  /// Adds the matches of the image stamped `stamp` [s], which was searched for all names. Returns
  /// the matches in the given order, followed by the held instances. A stamp before the last one
  /// resets the tracker first, and frees the frame indices: the clock has jumped back.
  std::vector<TrackedMatch> update(double stamp, const std::vector<Match>& matches);

  /// Every instance must be confirmed again; one that has not moved keeps its id and frame.
  void interrupt();

  /// Drops all instances. Their ids are not reused, and their frame indices only after reuse_after.
  void reset();

 private:
  struct Sighting {
    double stamp;  // [s]
    Pose2D pose;
    cv::Matx33d covariance;
  };
  struct Track {
    TrackedMatch last;
    double begun = 0;                // [s] stamp of the first sighting
    cv::Point2d velocity;            // [px/s] between the last two detections
    std::deque<bool> graspable;      // of the last images, newest last
    std::deque<Sighting> sightings;  // of the last half second, newest last
    int missed = 0;                  // images in a row
    bool seen = false;               // in the current image

    double distance_to(const Match& match, double stamp) const;
    void add_sighting();
    double validity() const;
  };
  struct ReleasedFrame {
    std::string name;
    int index;
    double at;  // [s]
  };

  std::vector<Track*> associate(double stamp, const std::vector<Match>& matches);
  Track& begin_track(double stamp, const Match& match);
  void see(Track& track, const Match& found, double stamp);
  void note_missed();
  void choose_best(std::vector<TrackedMatch>& tracked);
  std::vector<std::string> reasons_of(const Track& track) const;
  bool is_held(const Track& track, double stamp) const;
  void drop_lost(double stamp);
  void release(const Track& track, double stamp);
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
