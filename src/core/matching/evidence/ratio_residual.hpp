// SPDX-License-Identifier: BSD-3-Clause
// Residual of a surface by the ratios of its colours at neighbouring points. Illumination changes
// both by nearly the same factor (Land and McCann, "Lightness and retinex theory", JOSA 61, 1971).
#pragma once

#include <utility>
#include <vector>

#include "matching/evidence/evidence.hpp"
#include "matching/template/surface_template.hpp"

namespace mbncc::evidence {

class RatioResidual {
 public:
  /// Empty, without a surface.
  RatioResidual() = default;

  /// `area` [px at level] of the map that the surface's points are spread over.
  RatioResidual(const templates::SurfaceTemplate& surface, double area);

  /// ln of the median difference [%] between the ratios in a `sample` of that `surface` and in the
  /// template, 1 at least. A common gain of the channels and smooth shading hardly change it. A
  /// shadow changes only the ratios across its edge; gloss and covers do not decide while they
  /// touch less than half of the pairs. 0 where nothing can be compared.
  double misfit(const templates::SurfaceTemplate& surface,
                const templates::SurfaceSample& sample) const;

 private:
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  // neighbours
};

/// rotation_odds() where the surface's `misfit` is known as well: more accurate, on another scale,
/// not comparable with the one of the evidence alone.
double rotation_odds(const Evidence& evidence, double misfit);

}  // namespace mbncc::evidence
