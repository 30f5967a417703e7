// SPDX-License-Identifier: BSD-3-Clause
// The colours of a surface along three axes per point: brightness, which shading changes, and two
// axes orthogonal to it, which shading does not change.
#pragma once

#include <array>
#include <vector>

#include "matching/template/surface_template.hpp"
#include "numeric/normal_equations.hpp"

namespace mbncc::refinement {

class ColourAxes {
 public:
  static constexpr int kAxes = 3;
  static constexpr int kBrightness = 0;

  ColourAxes() = default;

  /// Axes at the points of `surface`. Their slopes are read from `image`.
  ColourAxes(const templates::SurfaceTemplate& surface, const scene::PreparedPixels& image);

  /// Residual of `sample` along an axis, one value per point, padded. Smooth shading is projected
  /// out, and so is the template along brightness, or a uniform tint along the other axes.
  void remainder(int axis, const templates::ShadingBasis& shading,
                 const templates::SurfaceSample& sample, std::vector<float>& values) const;

  /// Mean square [grey^2] of the lesson's noise orthogonal to brightness: the part of the template
  /// that is missing in an image with these residuals and `gain` times the template's contrast.
  double noise(const std::array<std::vector<float>, kAxes>& remainders,
               const std::vector<float>& weights, double gain) const;

  /// [0..1] Part of the slopes along an axis that is not caused by `noise`, see noise().
  double reliability(int axis, double noise) const;

  /// Normal equations summed over the points with their `weights`, from these residuals and the
  /// slopes; to be divided by the variance of the residuals.
  numeric::NormalEquations pull(int axis, const std::vector<float>& remainder,
                                const std::vector<float>& weights) const;

 private:
  struct Axis {
    std::array<std::vector<float>, templates::SurfaceTemplate::kChannels>
        direction;              // unit, of b, g, r
    std::vector<float> even;    // unit row: the template along brightness, white light across it
    std::vector<float> shown;   // remainder() of the template; 0 along brightness
    std::vector<float> slopes;  // kMotionParts rows, orthogonal to shading and `even`
    double energy = 0;          // of the slopes along x and y
  };

  void choose_directions(const templates::SurfaceTemplate& surface);
  void add_even(int axis, const templates::SurfaceTemplate& surface);
  void add_shown(int axis, const templates::SurfaceTemplate& surface);
  void add_slopes(int axis, const templates::SurfaceTemplate& surface,
                  const templates::SurfaceTemplate::Slopes& slopes);

  std::array<Axis, kAxes> axes_;
  double count_ = 0;  // number of points
};

}  // namespace mbncc::refinement
