// SPDX-License-Identifier: BSD-3-Clause
// Estimates a colour cast of the light from an object at a pose.
#pragma once

#include <cmath>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "matching/template/block_sums.hpp"

namespace mbncc::evidence {

/// ln of the gains of an image's blue and red against its green.
struct ColourCast {
  double blue = 0, red = 0;

  double size() const { return std::hypot(blue, red); }
  /// Gains per channel (b, g, r).
  cv::Vec3d gains() const { return {std::exp(blue), 1, std::exp(red)}; }
};

/// Mean cast over the half of the surface's blocks that agree best, so that occluded blocks have no
/// influence. Dark and clipped blocks are left out; none if no block remains.
std::optional<ColourCast> local_cast(const std::vector<templates::BlockSums>& blocks);

/// The cast limited to plausible light; larger differences mean another object colour.
ColourCast bounded(const ColourCast& cast);

/// Removes the cast; colours stay in [0..255].
void remove_cast(const ColourCast& cast, templates::SurfaceSample& sample);
void remove_cast(const ColourCast& cast, std::vector<templates::BlockSums>& blocks);

}  // namespace mbncc::evidence
