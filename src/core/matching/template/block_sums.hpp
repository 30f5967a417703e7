// SPDX-License-Identifier: BSD-3-Clause
// Sums for comparing the colours of a surface's blocks (SamplePoints) with an image.
#pragma once

#include <array>
#include <vector>

#include "matching/template/surface_template.hpp"

namespace mbncc::templates {

/// Sums of one block over its points inside the image, by channel (b, g, r).
struct BlockSums {
  using Channels = std::array<double, SurfaceTemplate::kChannels>;

  double count = 0;                          ///< points
  Channels learned{}, seen{};                ///< colours of the template and of the image
  Channels learned_square{}, seen_square{};  ///< their squares
  Channels product{};                        ///< template times image
};

/// Sums of each block, see SamplePoints.
std::vector<BlockSums> block_sums(const SurfaceTemplate& surface, const SurfaceSample& sample);

}  // namespace mbncc::templates
