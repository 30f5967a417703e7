// SPDX-License-Identifier: BSD-3-Clause
// Colour difference between the blocks of a surface and an image, in the light that fits most of
// the blocks: an occluder of some blocks has no effect on the others.
#pragma once

#include <vector>

#include "matching/template/block_sums.hpp"

namespace mbncc::evidence {

/// Root mean square [grey levels] of the colour differences in the five of eight blocks that one
/// gain and one offset fit best (least trimmed squares, Rousseeuw 1984; two steps from the fit to
/// all blocks, so a local optimum). Negative if no block lies in the image.
double trimmed_residual(const std::vector<templates::BlockSums>& blocks);

}  // namespace mbncc::evidence
