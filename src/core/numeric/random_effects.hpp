// SPDX-License-Identifier: BSD-3-Clause
// Disagreement of several estimates of one pose.
#pragma once

#include <vector>

#include "numeric/normal_equations.hpp"

namespace mbncc::numeric {

/// Variance [px^2] between the estimates' shifts and rotations in excess of their covariances
/// (random-effects model of DerSimonian and Laird). `radius` [px] of the object makes rotations
/// comparable with shifts.
double random_effects_variance(const std::vector<NormalEquations>& estimates, double radius);

}  // namespace mbncc::numeric
