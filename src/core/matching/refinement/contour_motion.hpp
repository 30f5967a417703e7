// SPDX-License-Identifier: BSD-3-Clause
// Normal equations of a contour's distance to the edges of an image.
#pragma once

#include <vector>

#include "matching/template/contour_template.hpp"
#include "numeric/normal_equations.hpp"

namespace mbncc::refinement {

class ContourMotion {
 public:
  ContourMotion() = default;
  explicit ContourMotion(const templates::ContourTemplate& contour);

  /// Normal equations of the found edges, for independent errors of 1 px per point.
  numeric::NormalEquations pull(const templates::ContourSample& sample) const;

 private:
  std::size_t padded_ = 0;
  std::vector<float> rows_;  // kMotionParts rows of padded_ values
};

}  // namespace mbncc::refinement
