// SPDX-License-Identifier: BSD-3-Clause
// Colour residuals of the compact parts of a surface after a robust fit of the light, so that
// covered parts do not affect the others.
#pragma once

#include <vector>

#include "matching/template/block_sums.hpp"

namespace mbncc {

/// By compact part, rms [grey levels] of its colours after one gain and one offset, each difference
/// up to a bound; -1 if too little of it lies in the picture. Gain and offset are fitted to the
/// five of eight parts with the smallest residuals (least trimmed squares, Rousseeuw 1984).
/// `blocks` are those of the sample.
std::vector<double> block_residuals(const SurfaceTemplate& surface, const SurfaceSample& sample,
                                    const std::vector<BlockSums>& blocks);

/// Root mean square [grey levels] of the best five of eight; negative without any.
double best_of(const std::vector<double>& residuals);

}  // namespace mbncc
