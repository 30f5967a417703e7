// Whether comparisons of the same pose agree on it as well as they claim.
#pragma once

#include "matching/motion_pull.hpp"

namespace mbncc {

class Disagreement {
 public:
  /// `radius` [px] of what moves: makes a turn comparable with a shift.
  explicit Disagreement(double radius) : radius_(radius) {}

  void add(const MotionPull& pull);

  /// Of the squared deviations claimed, what they had to be multiplied by to explain how far the
  /// pulls' shifts and turns are apart from each other; at least 1.
  double factor() const;

 private:
  cv::Matx33d inverse_of(const MotionPull& pull) const;

  double radius_;
  MotionPull sum_;
  double squares_ = 0, freedom_ = 0;
};

}  // namespace mbncc
