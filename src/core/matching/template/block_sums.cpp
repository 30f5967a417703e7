// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/block_sums.hpp"

namespace mbncc::templates {

std::vector<BlockSums> block_sums(const SurfaceTemplate& surface, const SurfaceSample& sample) {
  std::vector<BlockSums> blocks;
  int begin = 0;
  for (const int end : surface.block_ends) {
    BlockSums sums;
    for (int i = begin; i < end; ++i) sums.count += sample.inside[i];
    for (int c = 0; c < SurfaceTemplate::kChannels; ++c) {
      float t = 0, s = 0, tt = 0, ts = 0, ss = 0;
      for (int i = begin; i < end; ++i) {
        const float learned = sample.inside[i] * surface.planes[c][i];
        const float seen = sample.inside[i] * sample.planes[c][i];
        t += learned;
        s += seen;
        tt += learned * learned;
        ts += learned * seen;
        ss += seen * seen;
      }
      sums.learned[c] = t;
      sums.seen[c] = s;
      sums.learned_square[c] = tt;
      sums.product[c] = ts;
      sums.seen_square[c] = ss;
    }
    blocks.push_back(sums);
    begin = end;
  }
  return blocks;
}

}  // namespace mbncc::templates
