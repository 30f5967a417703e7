// SPDX-License-Identifier: BSD-3-Clause
// Light of an object in an image, as a gain and an offset of its colours.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

namespace mbncc::evidence {

/// One gain and offset for the whole object and all channels.
struct GainOffset {
  double factor = 1, offset = 0;  ///< [1], [grey levels]

  /// The expected value [grey levels] for a value of the lesson.
  float of(float learned) const {
    return static_cast<float>(std::clamp(factor * learned + offset, 0.0, 255.0));
  }
};

/// From values [grey levels] of blue, green and red, point by point, and the points' `weights`, not
/// all of them 0. Robust to outliers such as parts of another colour.
GainOffset fit_gain_offset(const std::array<std::vector<float>, 3>& learned,
                           const std::array<std::vector<float>, 3>& seen,
                           const std::vector<float>& weights);

}  // namespace mbncc::evidence
