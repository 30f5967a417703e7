// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/rotation_peaks.hpp"

#include <algorithm>
#include <cmath>

#include "matching/refinement/gauss_newton.hpp"

namespace mbncc::search {

std::vector<templates::Candidate> rotation_peaks(const templates::PoseTemplate& object,
                                                 const scene::SceneLevel& scene,
                                                 const templates::Candidate& place, double arc) {
  const double rim = 2 * kPi * object.surface.radius();
  const int count = std::max(24, static_cast<int>(std::ceil(rim / arc)));
  std::vector<templates::Candidate> turned(count, place);
  for (int k = 0; k < count; ++k) {
    turned[k].pose.theta = wrap_angle(place.pose.theta + 2 * kPi * k / count);
    turned[k].value = refinement::align(object, scene, turned[k].pose, 0).value;
  }
  std::vector<templates::Candidate> peaks;
  for (int k = 0; k < count; ++k)
    if (turned[k].value >= turned[(k + 1) % count].value &&
        turned[k].value > turned[(k + count - 1) % count].value)
      peaks.push_back(turned[k]);
  templates::sort_by_value(peaks);
  return peaks;
}

}  // namespace mbncc::search
