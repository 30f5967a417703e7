// SPDX-License-Identifier: BSD-3-Clause
#include "matching/refinement/surface_residuals.hpp"

#include <algorithm>

namespace mbncc::refinement {

void SurfaceResiduals::read(const ColourAxes& axes, const templates::SurfaceTemplate& surface,
                            const templates::SurfaceSample& sample) {
  constexpr float kUsual = 4;  // [variances] mean square that halves the weight
  for (int axis = 0; axis < ColourAxes::kAxes; ++axis)
    axes.remainder(axis, surface.basis, sample, values[axis]);
  weights = sample.inside;
  for (int pass = 0; pass < 2; ++pass) {
    const Variances scale = variances();
    for (std::size_t i = 0; i < weights.size(); ++i) {
      float square = 0;
      for (int axis = 0; axis < ColourAxes::kAxes; ++axis)
        square += values[axis][i] * values[axis][i] / static_cast<float>(scale[axis]);
      weights[i] = sample.inside[i] / (1 + square / (ColourAxes::kAxes * kUsual));
    }
  }
}

SurfaceResiduals::Variances SurfaceResiduals::variances() const {
  constexpr double kQuantised = 0.05;  // [grey^2] least noise, by quantisation
  Variances found{};
  double total = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    total += weights[i];
    for (int axis = 0; axis < ColourAxes::kAxes; ++axis)
      found[axis] += weights[i] * values[axis][i] * values[axis][i];
  }
  for (double& variance : found) variance = variance / std::max(total, 1e-6) + kQuantised;
  found[1] = found[2] = (found[1] + found[2]) / 2;
  return found;
}

}  // namespace mbncc::refinement
