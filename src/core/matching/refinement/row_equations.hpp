// SPDX-License-Identifier: BSD-3-Clause
// Normal equations from the rows of a Jacobian.
#pragma once

#include <vector>

#include "numeric/normal_equations.hpp"

namespace mbncc::refinement {

/// Normal equations of residuals at the points of a template: `rows` holds the Jacobian, one row of
/// points for each part of a motion; `weights` are those of the points, `moments` the weighted
/// residuals. The lengths are multiples of whole lanes.
numeric::NormalEquations equations_of(const std::vector<float>& rows,
                                      const std::vector<float>& weights,
                                      const std::vector<float>& moments);

/// Elementwise product of `a` with as many values of `b`.
std::vector<float> multiplied(const std::vector<float>& a, const float* b);

}  // namespace mbncc::refinement
