// Averages the poses of tracked instances over several pictures of a scene at rest.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "mbncc/cell/tracker.hpp"

namespace mbncc {

class PoseAverage {
 public:
  /// Takes the instances of one more picture; held ones do not count.
  void add(const std::vector<TrackedMatch>& matches);

  /// Puts the mean pose of each instance into `matches` and divides its covariance by the number of
  /// pictures. Poses whose angle lies more than 15 degrees from the one in `matches`, symmetry
  /// aside, are left out.
  void apply(std::vector<TrackedMatch>& matches) const;

 private:
  std::map<std::uint32_t, std::vector<Pose2D>> poses_;  // by instance
};

}  // namespace mbncc
