// SPDX-License-Identifier: BSD-3-Clause
#include "matching/refinement/row_equations.hpp"

#include <array>

#include "simd/lanes.hpp"

namespace mbncc::refinement {

numeric::NormalEquations equations_of(const std::vector<float>& rows,
                                      const std::vector<float>& weights,
                                      const std::vector<float>& moments) {
  const std::size_t points = weights.size();
  const auto along_rows = [&](const std::vector<float>& values) {
    std::array<float, numeric::kMotionParts> products;
    kernels::dots(rows.data(), points, numeric::kMotionParts, values.data(),
                  static_cast<int>(points), products.data());
    return products;
  };
  numeric::NormalEquations equations;
  const auto vector = along_rows(moments);
  for (int j = 0; j < numeric::kMotionParts; ++j) {
    equations.vector[j] = vector[j];
    const auto row = along_rows(multiplied(weights, &rows[j * points]));
    for (int k = 0; k < numeric::kMotionParts; ++k) equations.information(j, k) = row[k];
  }
  return equations;
}

std::vector<float> multiplied(const std::vector<float>& a, const float* b) {
  std::vector<float> products(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) products[i] = a[i] * b[i];
  return products;
}

}  // namespace mbncc::refinement
