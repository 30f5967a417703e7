// SPDX-License-Identifier: BSD-3-Clause
// How a contour's distance from the edges of a picture depends on a small motion.
#pragma once

#include <vector>

#include "matching/template/contour_template.hpp"
#include "numeric/normal_equations.hpp"

namespace mbncc {

class ContourMotion {
 public:
  ContourMotion() = default;
  explicit ContourMotion(const ContourTemplate& contour);

  /// Pull of the edges found, for points that scatter by 1 px each, independently.
  NormalEquations pull(const ContourSample& sample) const;

 private:
  std::size_t padded_ = 0;
  std::vector<float> rows_;  // kMotionParts of padded_ values
};

}  // namespace mbncc
