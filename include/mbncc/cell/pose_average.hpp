// SPDX-License-Identifier: BSD-3-Clause
// Averages the poses of still instances over the last images.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "mbncc/cell/tracker.hpp"

namespace mbncc {

/// Averaging restarts when an instance has moved: when its last poses show a trend beyond their
/// scatter, or its angle jumps. The part of the covariance that scatters between images is divided
/// by their number; the part that may be common to all images remains.
class PoseAverage {
 public:
  /// Averages over at most this many images. Throws std::invalid_argument below 1.
  explicit PoseAverage(int most);

  /// Adds the instances of the next image and replaces each pose by its mean. Held instances get
  /// their last mean; instances not listed are dropped.
  void apply(std::vector<TrackedMatch>& matches);

  void reset() { still_.clear(); }

 private:
  using Poses = std::deque<Pose2D>;  // angles unwrapped about the first one

  void add(Poses& poses, const Match& match) const;

  std::size_t most_;
  std::map<std::uint32_t, Poses> still_;  // by instance id
};

}  // namespace mbncc
