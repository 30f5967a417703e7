// SPDX-License-Identifier: BSD-3-Clause
// The light that a picture shows an object's colours in.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

namespace mbncc {

/// As if it were the same all over the object and for all channels.
struct Light {
  double factor = 1, offset = 0;  ///< [1], [grey levels]

  /// What a value [grey levels] of the lesson becomes.
  float of(float learned) const {
    return static_cast<float>(std::clamp(factor * learned + offset, 0.0, 255.0));
  }
};

/// From values [grey levels] of blue, green and red, point by point, and the points' `weights`, not
/// all of them 0. Those that do not fit, as parts of another colour, count little.
Light fit_light(const std::array<std::vector<float>, 3>& learned,
                const std::array<std::vector<float>, 3>& seen, const std::vector<float>& weights);

}  // namespace mbncc
