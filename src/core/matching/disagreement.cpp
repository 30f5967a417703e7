#include "matching/disagreement.hpp"

#include <algorithm>

namespace mbncc {
namespace {

cv::Matx33d information_of(const MotionPull& pull) {
  return pull.information.get_minor<3, 3>(0, 0);
}

cv::Vec3d vector_of(const MotionPull& pull) {
  return {pull.vector[0], pull.vector[1], pull.vector[2]};
}

}  // namespace

/// What a pull knows nothing about cannot disagree.
cv::Matx33d Disagreement::inverse_of(const MotionPull& pull) const {
  constexpr double kLeast = 0.01;  // [1/px^2]
  return (information_of(pull) + cv::Matx33d::diag({kLeast, kLeast, kLeast * radius_ * radius_}))
      .inv();
}

void Disagreement::add(const MotionPull& pull) {
  const cv::Matx33d inverse = inverse_of(pull);
  squares_ += vector_of(pull).dot(inverse * vector_of(pull));
  freedom_ += cv::trace(information_of(pull) * inverse);
  sum_ += pull;
}

double Disagreement::factor() const {
  const cv::Matx33d inverse = inverse_of(sum_);
  const double squares = squares_ - vector_of(sum_).dot(inverse * vector_of(sum_));
  const double freedom = freedom_ - cv::trace(information_of(sum_) * inverse);
  return std::max(1.0, squares / std::max(1.0, freedom));
}

}  // namespace mbncc
