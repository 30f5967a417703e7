// SPDX-License-Identifier: BSD-3-Clause
// Light on an object in an image, modelled as a gain and an offset of its colours.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "matching/template/surface_template.hpp"

namespace mbncc::evidence {

/// One gain and offset for the whole object and all channels.
struct GainOffset {
  double factor = 1, offset = 0;  ///< [1], [grey levels]

  /// The expected value [grey levels] for a value of the lesson.
  float of(float learned) const {
    return static_cast<float>(std::clamp(factor * learned + offset, 0.0, 255.0));
  }
};

/// Fits gain and offset to corresponding values [grey levels], per channel (b, g, r) and point.
/// `weights`, one per point, must not all be 0. Robust to outliers such as parts of another colour.
GainOffset fit_gain_offset(const std::array<std::vector<float>, 3>& learned,
                           const std::array<std::vector<float>, 3>& seen,
                           const std::vector<float>& weights);

/// Light on the surface; the lesson's if nothing of it is seen.
GainOffset light_on(const templates::SurfaceTemplate& surface,
                    const templates::SurfaceSample& sample);

}  // namespace mbncc::evidence
