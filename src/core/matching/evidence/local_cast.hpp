// SPDX-License-Identifier: BSD-3-Clause
// Light of another colour than in the lesson, told by an object where it may lie.
#pragma once

#include <cmath>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "matching/template/block_sums.hpp"

namespace mbncc {

/// ln of the gains of a picture's blue and red against its green.
struct ColourCast {
  double blue = 0, red = 0;

  double size() const { return std::hypot(blue, red); }
  /// By channel, as factors: b, g, r.
  cv::Vec3d gains() const { return {std::exp(blue), 1, std::exp(red)}; }
};

/// Mean over the half of the surface's compact parts that agree best, of those neither dark nor
/// clipped, so that what covers some of them counts for nothing; none where no part tells.
std::optional<ColourCast> local_cast(const std::vector<BlockSums>& blocks);

/// The cast within bounds that light has beside its brightness: more is another colour.
ColourCast bounded(const ColourCast& cast);

/// As without the cast; colours stay in [0..255].
void take_out(const ColourCast& cast, SurfaceSample& sample);
void take_out(const ColourCast& cast, std::vector<BlockSums>& blocks);

}  // namespace mbncc
