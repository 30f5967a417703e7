// SPDX-License-Identifier: BSD-3-Clause
// Sums for comparing the colours of a surface's compact parts with a picture.
#pragma once

#include <array>
#include <vector>

#include "matching/template/surface_template.hpp"

namespace mbncc::templates {

/// Sums of one compact part over its points inside the picture, by channel (b, g, r).
struct BlockSums {
  using Channels = std::array<double, SurfaceTemplate::kChannels>;

  double count = 0;                          ///< points
  Channels learned{}, seen{};                ///< colours of the template and of the picture
  Channels learned_square{}, seen_square{};  ///< their squares
  Channels product{};                        ///< template times picture
};

/// At most kMostBlocks.
std::vector<BlockSums> block_sums(const SurfaceTemplate& surface, const SurfaceSample& sample);

}  // namespace mbncc::templates
