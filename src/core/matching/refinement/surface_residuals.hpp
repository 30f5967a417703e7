// SPDX-License-Identifier: BSD-3-Clause
// Residuals of a surface along its colour axes, with the points' weights.
#pragma once

#include <array>
#include <vector>

#include "matching/refinement/colour_axes.hpp"
#include "matching/template/surface_template.hpp"

namespace mbncc::refinement {

struct SurfaceResiduals {
  using Variances = std::array<double, ColourAxes::kAxes>;

  std::array<std::vector<float>, ColourAxes::kAxes> values;
  std::vector<float> weights;  ///< [0..1] of the points

  /// Computes values and weights. Occluded and glossy points have little weight.
  void read(const ColourAxes& axes, const templates::SurfaceTemplate& surface,
            const templates::SurfaceSample& sample);

  /// [grey^2] Variances along the axes; the two axes orthogonal to brightness have the same.
  Variances variances() const;
};

}  // namespace mbncc::refinement
