// SPDX-License-Identifier: BSD-3-Clause
#include "matching/refinement/contour_motion.hpp"

#include <array>

#include "matching/refinement/row_equations.hpp"

namespace mbncc::refinement {

ContourMotion::ContourMotion(const templates::ContourTemplate& contour)
    : padded_(contour.x.size()), rows_(numeric::kMotionParts * padded_, 0.f) {
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const float x = contour.x[i], y = contour.y[i];
    const float nx = contour.normal_x[i], ny = contour.normal_y[i];
    const std::array<float, numeric::kMotionParts> distance{nx, ny, ny * x - nx * y,
                                                            nx * x + ny * y};
    for (std::size_t k = 0; k < numeric::kMotionParts; ++k) rows_[k * padded_ + i] = distance[k];
  }
}

numeric::NormalEquations ContourMotion::pull(const templates::ContourSample& sample) const {
  numeric::NormalEquations equations = equations_of(rows_, sample.pull, sample.moment);
  equations.vector = -equations.vector;  // the template moves opposite to the moments
  return equations;
}

}  // namespace mbncc::refinement
