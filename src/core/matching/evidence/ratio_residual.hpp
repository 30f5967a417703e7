// SPDX-License-Identifier: BSD-3-Clause
// Residual of a surface from the ratios of its colours at neighbouring points. Illumination changes
// the colours of both by nearly the same factor (Land and McCann, "Lightness and retinex theory",
// JOSA 61, 1971).
#pragma once

#include <utility>
#include <vector>

#include "matching/evidence/evidence.hpp"
#include "matching/template/surface_template.hpp"

namespace mbncc::evidence {

class RatioResidual {
 public:
  /// Without a surface, the residual is always 0.
  RatioResidual() = default;

  /// `area` [px at level]: area of the map over which the surface's points are spread.
  RatioResidual(const templates::SurfaceTemplate& surface, double area);

  /// ln of the median difference [%, at least 1] between the ratios in `sample` and in its template
  /// `surface`, which must be that of the constructor. A common gain of the channels and smooth
  /// shading hardly change it. A shadow changes only the ratios across its edge; gloss and
  /// occluders have little effect while they touch less than half of the pairs. 0 where nothing can
  /// be compared.
  double misfit(const templates::SurfaceTemplate& surface,
                const templates::SurfaceSample& sample) const;

 private:
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  // neighbours
};

/// rotation_odds() that also uses RatioResidual::misfit(): more accurate, but on another scale, so
/// not comparable with that of the evidence alone.
double rotation_odds(const Evidence& evidence, double misfit);

}  // namespace mbncc::evidence
