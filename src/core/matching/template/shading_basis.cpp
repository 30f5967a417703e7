// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/shading_basis.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "simd/lanes.hpp"

namespace mbncc::templates {
namespace {

/// All functions at a point whose position, in radii, is (u, v). The most important come first:
/// small surfaces have only some of them.
std::array<float, ShadingBasis::kMostRows> functions_at(float u, float v,
                                                        const SurfacePoint& point) {
  const float rim = std::exp(-point.depth / 1.5f), bevel = std::exp(-point.depth / 4.f);
  const cv::Point2f inward = point.inward;
  return {1,
          u,
          v,
          bevel * inward.x,
          bevel * inward.y,
          bevel,
          rim * inward.x,
          rim * inward.y,
          rim,
          u * u,
          u * v,
          v * v};
}

}  // namespace

ShadingBasis::ShadingBasis(const std::vector<SurfacePoint>& points, const std::vector<float>& x,
                           const std::vector<float>& y, double radius)
    : padded_(x.size()) {
  const std::size_t wanted = points.size() >= 150 ? kMostRows : points.size() >= 60 ? 6 : 3;
  std::vector<std::vector<float>> rows(wanted, std::vector<float>(padded_, 0.f));
  const auto unit = static_cast<float>(radius);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto functions = functions_at(x[i] / unit, y[i] / unit, points[i]);
    for (std::size_t k = 0; k < wanted; ++k) rows[k][i] = functions[k];
  }
  for (auto& row : rows) add(std::move(row));
}

/// Adds the part of `values` that is orthogonal to the previous rows, normalised, unless it is
/// negligible.
void ShadingBasis::add(std::vector<float> values) {
  const double before = kernels::product(values, values.data());
  for (int pass = 0; pass < 2; ++pass) project_out(values);
  const double after = kernels::product(values, values.data());
  if (after < 1e-3 * before || after < 1e-9) return;
  for (auto& value : values) value /= static_cast<float>(std::sqrt(after));
  rows_.insert(rows_.end(), values.begin(), values.end());
  ++size_;
}

void ShadingBasis::project_out(std::vector<float>& values) const {
  for (int k = 0; k < size_; ++k)
    kernels::subtract(values, kernels::product(values, row(k)), row(k));
}

void ShadingBasis::products(const float* values, float* products) const {
  kernels::dots(rows_.data(), padded_, size_, values, static_cast<int>(padded_), products);
}

}  // namespace mbncc::templates
