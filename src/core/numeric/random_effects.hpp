// SPDX-License-Identifier: BSD-3-Clause
// Comparisons of the same pose, none of which knows what displaces the others.
#pragma once

#include <vector>

#include "numeric/normal_equations.hpp"

namespace mbncc {

class RandomEffects {
 public:
  /// `radius` [px] of what moves: makes a turn comparable with a shift.
  explicit RandomEffects(double radius) : radius_(radius) {}

  void add(const NormalEquations& pull) { pulls_.push_back(pull); }

  /// [px^2] How far the comparisons' shifts and turns are apart beyond what they claim: the
  /// variance that each has to be given to explain it (DerSimonian and Laird's random effects).
  double variance() const;

 private:
  double radius_;
  std::vector<NormalEquations> pulls_;
};

}  // namespace mbncc
