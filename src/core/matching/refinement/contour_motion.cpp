// SPDX-License-Identifier: BSD-3-Clause
#include "matching/refinement/contour_motion.hpp"

#include <array>

#include "simd/lanes.hpp"

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
  const auto along_rows = [&](const std::vector<float>& values) {
    std::array<float, numeric::kMotionParts> products;
    kernels::dots(rows_.data(), padded_, numeric::kMotionParts, values.data(),
                  static_cast<int>(padded_), products.data());
    return products;
  };
  numeric::NormalEquations pull;
  std::vector<float> weighted(padded_);
  for (int j = 0; j < numeric::kMotionParts; ++j) {
    for (std::size_t i = 0; i < padded_; ++i) weighted[i] = rows_[j * padded_ + i] * sample.pull[i];
    const auto row = along_rows(weighted);
    for (int k = 0; k < numeric::kMotionParts; ++k) pull.information(j, k) = row[k];
  }
  const auto moments = along_rows(sample.moment);
  // The template moves opposite to the moments.
  for (int j = 0; j < numeric::kMotionParts; ++j) pull.vector[j] = -moments[j];
  return pull;
}

}  // namespace mbncc::refinement
