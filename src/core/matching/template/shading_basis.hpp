// SPDX-License-Identifier: BSD-3-Clause
// Basis of smooth functions that model shading.
#pragma once

#include <vector>

#include "matching/template/sample_points.hpp"

namespace mbncc::templates {

/// Shading and gloss near the edge depend on the light, not on the object: functions of the
/// position and of the distance to the edge, to be projected out of template and image.
class ShadingBasis {
 public:
  static constexpr int kMostRows = 12;

  ShadingBasis() = default;

  /// For `points` at x, y [px at level, about the anchor; padded to whole lanes] within `radius`.
  ShadingBasis(const std::vector<SurfacePoint>& points, const std::vector<float>& x,
               const std::vector<float>& y, double radius);

  int size() const { return size_; }

  /// Projects the functions out of `values`, one per point and padded.
  void project_out(std::vector<float>& values) const;

  /// Scalar products of all functions, the constant first, with as many `values` as padded points.
  void products(const float* values, float* products) const;

 private:
  /// Function `k`, as many values as padded points; the functions are orthonormal.
  const float* row(int k) const { return &rows_[static_cast<std::size_t>(k) * padded_]; }
  void add(std::vector<float> row);

  int size_ = 0;
  std::size_t padded_ = 0;
  std::vector<float> rows_;  // size_ orthonormal rows of padded_ values
};

}  // namespace mbncc::templates
