// SPDX-License-Identifier: BSD-3-Clause
// Random-effects variance of several estimates of one pose.
#pragma once

#include <vector>

#include "numeric/normal_equations.hpp"

namespace mbncc::numeric {

class RandomEffects {
 public:
  /// `radius` [px] of the object; it makes rotations comparable with shifts.
  explicit RandomEffects(double radius) : radius_(radius) {}

  void add(const NormalEquations& pull) { pulls_.push_back(pull); }

  /// Variance [px^2] between the estimates' shifts and rotations in excess of their covariances
  /// (random-effects model of DerSimonian and Laird).
  double variance() const;

 private:
  double radius_;
  std::vector<NormalEquations> pulls_;
};

}  // namespace mbncc::numeric
