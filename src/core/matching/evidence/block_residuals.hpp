// How far the compact parts of a surface differ in colour from a picture, in the light that
// explains most of them: what covers some of the parts decides nothing about the others.
#pragma once

#include <vector>

#include "matching/template/block_sums.hpp"

namespace mbncc {

/// Root mean square [grey levels] of the colour differences in the five of eight parts that one
/// gain and one offset explain best (least trimmed squares, Rousseeuw 1984); negative where no part
/// lies in the picture.
double trimmed_residual(const std::vector<BlockSums>& blocks);

}  // namespace mbncc
