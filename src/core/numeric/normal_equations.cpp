// SPDX-License-Identifier: BSD-3-Clause
#include "numeric/normal_equations.hpp"

namespace mbncc::numeric {

NormalEquations& NormalEquations::operator+=(const NormalEquations& other) {
  information += other.information;
  vector += other.vector;
  return *this;
}

NormalEquations marginalised_over_shift(const NormalEquations& pull, double deviation) {
  const double prior = 1 / (deviation * deviation);
  const cv::Matx<double, kMotionParts, 2> cross = pull.information.get_minor<kMotionParts, 2>(0, 0);
  const cv::Matx22d own = pull.information.get_minor<2, 2>(0, 0) + cv::Matx22d::eye() * prior;
  const cv::Matx<double, kMotionParts, 2> share = cross * own.inv();
  NormalEquations loose = pull;
  loose.information -= share * cross.t();
  loose.vector -= share * cv::Vec2d(pull.vector[0], pull.vector[1]);
  return loose;
}

NormalEquations marginalised_over_shift_and_turn(const NormalEquations& pull, double deviation,
                                                 double radius) {
  const double place = deviation * deviation, turn = place / (radius * radius);
  const cv::Matx44d share =
      (cv::Matx44d::eye() + pull.information * cv::Matx44d::diag({place, place, turn, turn})).inv();
  const cv::Matx44d information = share * pull.information;
  return {0.5 * (information + information.t()), share * pull.vector};
}

}  // namespace mbncc::numeric
