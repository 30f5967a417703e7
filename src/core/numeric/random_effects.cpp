// SPDX-License-Identifier: BSD-3-Clause
#include "numeric/random_effects.hpp"

#include <algorithm>

namespace mbncc::numeric {
namespace {

/// Normal equations of a shift, and of a rotation as an arc [px] at the object's rim.
struct Pull3 {
  cv::Matx33d information;
  cv::Vec3d vector;

  Pull3() = default;
  Pull3(const NormalEquations& pull, double radius) {
    const cv::Matx33d arc = cv::Matx33d::diag({1, 1, 1 / radius});
    information = arc * pull.information.get_minor<3, 3>(0, 0) * arc;
    vector = arc * cv::Vec3d(pull.vector[0], pull.vector[1], pull.vector[2]);
  }

  /// Directions without information cannot disagree.
  cv::Matx33d inverse() const {
    constexpr double kLeast = 0.01;  // [1/px^2]
    return (information + kLeast * cv::Matx33d::eye()).inv();
  }
  double squares() const { return vector.dot(inverse() * vector); }
  double freedom() const { return cv::trace(information * inverse()); }
};

}  // namespace

double random_effects_variance(const std::vector<NormalEquations>& estimates, double radius) {
  Pull3 sum;
  cv::Matx33d products;
  double squares = 0, freedom = 0;
  for (const auto& one : estimates) {
    const Pull3 pull(one, radius);
    sum.information += pull.information;
    sum.vector += pull.vector;
    products += pull.information * pull.information;
    squares += pull.squares();
    freedom += pull.freedom();
  }
  const double excess = squares - sum.squares() - (freedom - sum.freedom());
  const double weight = cv::trace(sum.information) - cv::trace(sum.inverse() * products);
  return weight > 0 ? std::max(0.0, excess / weight) : 0;
}

}  // namespace mbncc::numeric
