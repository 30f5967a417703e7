// SPDX-License-Identifier: BSD-3-Clause
// Least squares in light and motion together for a rendered object: what they add up to, at each
// point and along each axis of colour, is to be what is seen there.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/refinement/mixed_pixel_model.hpp"
#include "matching/refinement/mixed_pixel_sample.hpp"

namespace mbncc {

class MixedPixelEquations {
 public:
  static constexpr int kAxes = MixedPixelModel::kChannels, kMotion = 3;
  using Light = std::array<double, MixedPixelModel::kLight>;

  explicit MixedPixelEquations(const MixedPixelModel& object);

  /// `reading` is what light and motion are to explain from now on.
  void see(const MixedPixelSample& reading);
  /// Of what is seen, by x, y and a turn [per px, at the rim]: differences between `low` and
  /// `high`, which were read a pixel apart.
  void set_slope(int motion, const MixedPixelSample& low, const MixedPixelSample& high);

  /// Weights of all values, 1 at first.
  std::vector<float>& weights() { return weights_; }
  const std::vector<float>& weights() const { return weights_; }

  /// The light that explains best what is seen, without motion ...
  Light light() const;
  /// ... and the motion [px, at the rim] that explains it best, with light of its own.
  cv::Vec3d motion() const;

  /// What the light leaves unexplained, per axis and point.
  void subtract(const Light& light, std::vector<float>& residual) const;

 private:
  // Rows of an axis: its terms of light, what is seen, slopes.
  static constexpr int kSeen = MixedPixelModel::kLight, kUnknowns = kSeen + 1 + kMotion;

  std::size_t padded() const { return object_.padded(); }
  static int terms(int axis) { return static_cast<int>(MixedPixelModel::terms_along(axis).size()); }
  float* row(int axis, int k) { return &rows_[axis][k * padded()]; }
  const float* row(int axis, int k) const { return &rows_[axis][k * padded()]; }

  cv::Mat1d products(int rows_beside_light) const;
  cv::Mat1d solved(const cv::Mat1d& products, const std::vector<int>& unknowns) const;

  const MixedPixelModel& object_;
  std::array<std::vector<float>, kAxes> rows_;
  std::vector<float> weights_, inside_;
};

}  // namespace mbncc
