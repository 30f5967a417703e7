// SPDX-License-Identifier: BSD-3-Clause
// Random-effects variance of several estimates of one pose.
#pragma once

#include <vector>

#include "numeric/normal_equations.hpp"

namespace mbncc::numeric {

class RandomEffects {
 public:
  /// `radius` [px] of the object: makes rotations comparable with shifts.
  explicit RandomEffects(double radius) : radius_(radius) {}

  void add(const NormalEquations& pull) { pulls_.push_back(pull); }

  /// [px^2] Variance between the estimates' shifts and rotations beyond their covariances
  /// (DerSimonian and Laird's random effects).
  double variance() const;

 private:
  double radius_;
  std::vector<NormalEquations> pulls_;
};

}  // namespace mbncc::numeric
