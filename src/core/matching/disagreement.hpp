// Comparisons of the same pose, none of which knows what displaces the others.
#pragma once

#include <vector>

#include "matching/motion_pull.hpp"

namespace mbncc {

class Disagreement {
 public:
  /// `radius` [px] of what moves: makes a turn comparable with a shift.
  explicit Disagreement(double radius) : radius_(radius) {}

  void add(const MotionPull& pull) { pulls_.push_back(pull); }

  /// [px^2] How far the comparisons' shifts and turns are apart beyond what they claim: the
  /// variance that each has to be given to explain it (DerSimonian and Laird's random effects).
  double variance() const;

 private:
  double radius_;
  std::vector<MotionPull> pulls_;
};

}  // namespace mbncc
