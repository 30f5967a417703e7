// SPDX-License-Identifier: BSD-3-Clause
// Averages the poses of instances that lie still, over the last pictures.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "mbncc/cell/tracker.hpp"

namespace mbncc {

/// An instance is averaged anew when it has moved: when its last poses show a trend beyond their
/// own scatter, or its angle jumps. The covariance loses the part of it that the pictures are seen
/// to scatter by, divided among them; what all pictures may share stays.
class PoseAverage {
 public:
  /// Takes at most this many pictures. Throws std::invalid_argument below 1.
  explicit PoseAverage(int most);

  /// Takes the instances of the next picture and puts each one's mean pose in its place. Held ones
  /// get their last mean; those not listed are forgotten.
  void apply(std::vector<TrackedMatch>& matches);

  void reset() { still_.clear(); }

 private:
  using Poses = std::deque<Pose2D>;  // angles unwrapped about the first one

  void add(Poses& poses, const Match& match) const;

  std::size_t most_;
  std::map<std::uint32_t, Poses> still_;  // by instance
};

}  // namespace mbncc
