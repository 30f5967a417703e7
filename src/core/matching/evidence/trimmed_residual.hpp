// SPDX-License-Identifier: BSD-3-Clause
// Colour difference between the compact parts of a surface and an image, in the light that fits
// most of the parts: what covers some of them has no effect on the others.
#pragma once

#include <vector>

#include "matching/template/block_sums.hpp"

namespace mbncc::evidence {

/// Root mean square [grey levels] of the colour differences in the five of eight parts that one
/// gain and one offset fit best (least trimmed squares, Rousseeuw 1984, by two steps from the light
/// of all parts: a local optimum); negative if no part lies in the image.
double trimmed_residual(const std::vector<templates::BlockSums>& blocks);

}  // namespace mbncc::evidence
