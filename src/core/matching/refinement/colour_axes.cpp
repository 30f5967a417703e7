// SPDX-License-Identifier: BSD-3-Clause
#include "matching/refinement/colour_axes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "matching/refinement/row_equations.hpp"
#include "simd/lanes.hpp"

namespace mbncc::refinement {
namespace {

constexpr int kChannels = templates::SurfaceTemplate::kChannels;

/// Scales to unit length; nearly zero vectors become zero.
void normalise(std::vector<float>& row) {
  const double square = kernels::product(row, row.data());
  const float scale = square < 1e-6 ? 0.f : static_cast<float>(1 / std::sqrt(square));
  for (auto& value : row) value *= scale;
}

}  // namespace

ColourAxes::ColourAxes(const templates::SurfaceTemplate& surface,
                       const scene::PreparedPixels& image)
    : count_(static_cast<double>(surface.size())) {
  choose_directions(surface);
  const auto slopes = surface.slopes_in(image);
  for (int axis = 0; axis < kAxes; ++axis) {
    add_even(axis, surface);
    add_shown(axis, surface);
    add_slopes(axis, surface, slopes);
  }
}

/// Shading multiplies a colour, except for the camera's offset.
void ColourAxes::choose_directions(const templates::SurfaceTemplate& surface) {
  constexpr double kAdded = 30;  // [grey levels] also stabilises the axes of dark points
  for (auto& axis : axes_)
    for (auto& part : axis.direction) part.assign(surface.padded(), 0.f);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const cv::Vec3d colour(surface.planes[0][i], surface.planes[1][i], surface.planes[2][i]);
    const cv::Vec3d brightness = cv::normalize(colour + cv::Vec3d::all(kAdded));
    const cv::Vec3d across = cv::normalize(brightness.cross(cv::Vec3d(0, 0, 1)));
    const std::array<cv::Vec3d, kAxes> directions{brightness, across, brightness.cross(across)};
    for (int axis = 0; axis < kAxes; ++axis)
      for (int c = 0; c < kChannels; ++c)
        axes_[axis].direction[c][i] = static_cast<float>(directions[axis][c]);
  }
}

void ColourAxes::add_even(int axis, const templates::SurfaceTemplate& surface) {
  auto& even = axes_[axis].even;
  even.assign(surface.padded(), 0.f);
  for (int c = 0; c < kChannels; ++c)
    for (std::size_t i = 0; i < surface.size(); ++i)
      even[i] += axes_[axis].direction[c][i] * (axis == kBrightness ? surface.planes[c][i] : 1.f);
  surface.basis.project_out(even);
  normalise(even);
}

void ColourAxes::add_shown(int axis, const templates::SurfaceTemplate& surface) {
  templates::SurfaceSample own;
  own.planes = surface.planes;
  remainder(axis, surface.basis, own, axes_[axis].shown);
}

void ColourAxes::add_slopes(int axis, const templates::SurfaceTemplate& surface,
                            const templates::SurfaceTemplate::Slopes& slopes) {
  Axis& own = axes_[axis];
  std::array<std::vector<float>, numeric::kMotionParts> rows;
  for (auto& row : rows) row.assign(surface.padded(), 0.f);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    for (int c = 0; c < kChannels; ++c)
      for (std::size_t k = 0; k < slopes[c].size(); ++k)
        rows[k][i] += own.direction[c][i] * slopes[c][k][i];
    rows[3][i] = rows[0][i] * surface.x[i] + rows[1][i] * surface.y[i];
  }
  for (auto& row : rows) {
    surface.basis.project_out(row);
    kernels::subtract(row, kernels::product(row, own.even.data()), own.even.data());
    own.slopes.insert(own.slopes.end(), row.begin(), row.end());
  }
  const auto end = own.slopes.begin() + static_cast<std::ptrdiff_t>(2 * surface.padded());
  own.energy = std::inner_product(own.slopes.begin(), end, own.slopes.begin(), 0.0);
}

void ColourAxes::remainder(int axis, const templates::ShadingBasis& shading,
                           const templates::SurfaceSample& sample,
                           std::vector<float>& values) const {
  const Axis& own = axes_[axis];
  values = multiplied(sample.planes[0], own.direction[0].data());
  for (int c = 1; c < kChannels; ++c)
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] += sample.planes[c][i] * own.direction[c][i];
  shading.project_out(values);
  kernels::subtract(values, kernels::product(values, own.even.data()), own.even.data());
}

double ColourAxes::noise(const std::array<std::vector<float>, kAxes>& remainders,
                         const std::vector<float>& weights, double gain) const {
  double noise = 0;
  for (int axis = kBrightness + 1; axis < kAxes; ++axis) {
    const auto seen = multiplied(weights, axes_[axis].shown.data());
    const double energy = kernels::product(seen, axes_[axis].shown.data());
    noise += energy - kernels::product(seen, remainders[axis].data()) / gain;
  }
  const double values = (kAxes - 1) * std::accumulate(weights.begin(), weights.end(), 1e-6);
  return std::max(0.0, noise / values);
}

double ColourAxes::reliability(int axis, double noise) const {
  constexpr double kSlopeNoise = 0.355;  // part of the noise in slopes over 2 px after smoothing
  constexpr double kLeast = 0.05;
  return std::max(kLeast, 1 - 2 * count_ * kSlopeNoise * noise / (axes_[axis].energy + 1e-9));
}

numeric::NormalEquations ColourAxes::pull(int axis, const std::vector<float>& remainder,
                                          const std::vector<float>& weights) const {
  return equations_of(axes_[axis].slopes, weights, multiplied(weights, remainder.data()));
}

}  // namespace mbncc::refinement
