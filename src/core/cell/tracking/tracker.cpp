// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace mbncc {
namespace {

constexpr double kGateShare = 0.5;            // gate as a part of the outline's radius
constexpr double kLeastGate = 5;              // [px] least gate
constexpr double kLongestGuess = 0.5;         // [s] for which a motion is extrapolated
constexpr double kAngleJump = to_radians(3);  // [rad] torn images cause larger jumps
constexpr double kObserved = 0.5;             // [s] for which sightings are compared

struct Motion {
  double distance, angle;  // [px], [rad]
};
constexpr Motion kAllowed{2, to_radians(1.5)};      // until a pose is no longer valid
constexpr Motion kUncounted{0.5, to_radians(0.5)};  // motions that are not counted, besides ...
constexpr double kDeviations = 3;                   // ... this many standard deviations
// A pose is valid for this many times as long as the instance has been observed, because a new one
// may move by up to kUncounted unnoticed.
constexpr double kAhead = 2;

/// Distance [px] within which a match continues an instance.
double gate_of(const Match& match) {
  double radius = 0;
  for (const auto& point : match.outline)
    radius = std::max(radius, cv::norm(cv::Point2d(point) - match.pose.position()));
  return std::max(kLeastGate, kGateShare * radius);
}

bool angle_jumped(const Match& a, const Match& b) {
  return angle_distance(a.pose.theta, b.pose.theta, b.symmetry) > kAngleJump;
}

}  // namespace

InstanceTracker::InstanceTracker(TrackerConfig config) {
  configure(config);
}

void InstanceTracker::configure(const TrackerConfig& config) {
  if (config.confirm_frames < 1 || config.confirm_frames > config.confirm_window)
    throw std::invalid_argument("parameter 'confirm_frames': value '" +
                                std::to_string(config.confirm_frames) +
                                "' is not allowed; give 1 .. confirm_window, which is " +
                                std::to_string(config.confirm_window));
  if (!(config.hold_time >= 0 && config.max_age >= 0 && config.reuse_after >= 0))
    throw std::invalid_argument("hold_time, max_age and reuse_after must not be negative");
  config_ = config;
}

void InstanceTracker::interrupt() {
  for (auto& track : tracks_) track.graspable.clear();
}

void InstanceTracker::reset() {
  for (const auto& track : tracks_) release(track, last_stamp_);
  tracks_.clear();
  best_.clear();
}

void InstanceTracker::release(const Track& track, double stamp) {
  released_.push_back({track.last.match.name, track.last.frame_index, stamp});
}

std::vector<TrackedMatch> InstanceTracker::update(double stamp, const std::vector<Match>& matches) {
  if (stamp < last_stamp_) {
    reset();
    released_.clear();
  }
  last_stamp_ = stamp;
  drop_lost(stamp);
  const std::vector<Track*> continued = associate(stamp, matches);
  std::vector<TrackedMatch> result;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    Track& track = continued[i] ? *continued[i] : begin_track(stamp, matches[i]);
    see(track, matches[i], stamp);
    result.push_back(track.last);
  }
  note_missed();
  for (const auto& track : tracks_) {
    if (track.seen || !is_held(track, stamp)) continue;
    result.push_back(track.last);
    result.back().state = TrackState::kHeld;
    result.back().reasons = {"not seen in this image"};
  }
  choose_best(result);
  return result;
}

void InstanceTracker::choose_best(std::vector<TrackedMatch>& tracked) {
  std::map<std::string, TrackedMatch*> best;
  const auto rank = [this](const TrackedMatch& one) {
    const auto before = best_.find(one.match.name);
    return std::make_pair(before != best_.end() && before->second == one.instance_id,
                          one.match.score);
  };
  for (auto& one : tracked) {
    if (one.state != TrackState::kConfirmed) continue;
    TrackedMatch*& chosen = best[one.match.name];
    if (!chosen || rank(one) > rank(*chosen)) chosen = &one;
  }
  for (const auto& [name, chosen] : best) {
    chosen->is_best = true;
    best_[name] = chosen->instance_id;
  }
}

/// Distance from the instance's last or extrapolated position, whichever is nearer; an object that
/// reverses its motion is near its last position. Infinite for another object.
double InstanceTracker::Track::distance_to(const Match& match, double stamp) const {
  const Match& before = last.match;
  if (before.name != match.name || before.revision != match.revision)
    return std::numeric_limits<double>::infinity();
  const cv::Point2d way =
      equivalent_towards(before.pose.theta, match).pose.position() - before.pose.position();
  const double passed = stamp - last.seen_at;
  if (passed > kLongestGuess) return cv::norm(way);
  return std::min(cv::norm(way), cv::norm(way - velocity * passed));
}

void InstanceTracker::Track::add_sighting() {
  sightings.push_back({last.seen_at, last.match.pose, last.match.covariance});
  while (sightings.size() > 2 && last.seen_at - sightings.front().stamp > kObserved)
    sightings.pop_front();
}

/// Time [s] for which the last pose is valid: until the instance has moved by kAllowed if it moves
/// on as it has since any earlier sighting; infinite after the first.
double InstanceTracker::Track::validity() const {
  const Sighting& now = sightings.back();
  const auto share_of = [](double motion, double uncounted, double allowed, double variance) {
    return std::max(0., motion - uncounted - kDeviations * std::sqrt(variance)) / allowed;
  };
  const double observed = now.stamp - begun;
  double valid = observed > 0 ? kAhead * observed : std::numeric_limits<double>::infinity();
  for (const auto& before : sightings) {
    const cv::Matx33d c = now.covariance + before.covariance;
    const double moved =
        std::max(share_of(cv::norm(now.pose.position() - before.pose.position()),
                          kUncounted.distance, kAllowed.distance, c(0, 0) + c(1, 1)),
                 share_of(angle_distance(now.pose.theta, before.pose.theta, last.match.symmetry),
                          kUncounted.angle, kAllowed.angle, c(2, 2)));
    if (moved > 0) valid = std::min(valid, (now.stamp - before.stamp) / moved);
  }
  return valid;
}

/// Nearest pairs first; nullptr if a match starts a new instance.
std::vector<InstanceTracker::Track*> InstanceTracker::associate(double stamp,
                                                                const std::vector<Match>& matches) {
  struct Pair {
    double distance;
    std::size_t match;
    Track* track;
  };
  std::vector<Pair> pairs;
  for (auto& track : tracks_) {
    track.seen = false;
    for (std::size_t i = 0; i < matches.size(); ++i) {
      const double distance = track.distance_to(matches[i], stamp);
      if (distance <= gate_of(matches[i])) pairs.push_back({distance, i, &track});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  std::vector<Track*> result(matches.size(), nullptr);
  for (const auto& pair : pairs) {
    if (pair.track->seen || result[pair.match]) continue;
    pair.track->seen = true;
    result[pair.match] = pair.track;
  }
  return result;
}

InstanceTracker::Track& InstanceTracker::begin_track(double stamp, const Match& match) {
  const int index = free_frame_index(match.name);
  Track& track = tracks_.emplace_back();
  track.last.match = match;
  track.last.seen_at = stamp;
  track.last.instance_id = next_id_++;
  track.begun = stamp;
  track.last.frame_index = index;
  return track;
}

void InstanceTracker::see(Track& track, const Match& found, double stamp) {
  const Match& before = track.last.match;
  const Match match = equivalent_towards(before.pose.theta, found);
  if (angle_jumped(before, match)) track.graspable.clear();
  if (stamp > track.last.seen_at)
    track.velocity =
        (match.pose.position() - before.pose.position()) * (1 / (stamp - track.last.seen_at));
  track.graspable.push_back(match.graspable);
  while (static_cast<int>(track.graspable.size()) > config_.confirm_window)
    track.graspable.pop_front();
  track.last.match = match;
  track.last.seen_at = stamp;
  track.add_sighting();
  track.last.valid_until = stamp + std::min(config_.max_age, track.validity());
  track.seen = true;
  track.missed = 0;
  const auto times = std::count(track.graspable.begin(), track.graspable.end(), true);
  if (match.ambiguous)
    track.last.state = TrackState::kAmbiguous;
  else if (match.graspable && times >= config_.confirm_frames)
    track.last.state = TrackState::kConfirmed;
  else
    track.last.state = TrackState::kNew;
  track.last.reasons = reasons_of(track);
}

std::vector<std::string> InstanceTracker::reasons_of(const Track& track) const {
  if (track.last.state == TrackState::kConfirmed) return {};
  if (!track.last.match.graspable) return track.last.match.reasons;
  const auto times = std::count(track.graspable.begin(), track.graspable.end(), true);
  return {"graspable in " + std::to_string(times) + " of the last " +
          std::to_string(config_.confirm_window) + " images, " +
          std::to_string(config_.confirm_frames) + " needed"};
}

void InstanceTracker::note_missed() {
  for (auto& track : tracks_) {
    if (track.seen) continue;
    ++track.missed;
    track.graspable.push_back(false);
    while (static_cast<int>(track.graspable.size()) > config_.confirm_window)
      track.graspable.pop_front();
  }
}

bool InstanceTracker::is_held(const Track& track, double stamp) const {
  return config_.hold_time > 0 && stamp - track.last.seen_at <= config_.hold_time;
}

void InstanceTracker::drop_lost(double stamp) {
  const auto lost = std::stable_partition(tracks_.begin(), tracks_.end(), [&](const Track& track) {
    return track.missed < config_.confirm_window || is_held(track, stamp);
  });
  for (auto track = lost; track != tracks_.end(); ++track) release(*track, stamp);
  tracks_.erase(lost, tracks_.end());
  released_.erase(std::remove_if(released_.begin(), released_.end(),
                                 [&](const ReleasedFrame& frame) {
                                   return stamp - frame.at >= config_.reuse_after;
                                 }),
                  released_.end());
}

int InstanceTracker::free_frame_index(const std::string& name) const {
  int index = 0;
  while (is_frame_taken(name, index)) ++index;
  return index;
}

bool InstanceTracker::is_frame_taken(const std::string& name, int index) const {
  const auto holds = [&](const Track& track) {
    return track.last.match.name == name && track.last.frame_index == index;
  };
  const auto held = [&](const ReleasedFrame& frame) {
    return frame.name == name && frame.index == index;
  };
  return std::any_of(tracks_.begin(), tracks_.end(), holds) ||
         std::any_of(released_.begin(), released_.end(), held);
}

}  // namespace mbncc
