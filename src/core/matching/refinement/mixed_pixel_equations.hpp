// SPDX-License-Identifier: BSD-3-Clause
// Joint least squares of light and motion for a rendered object, at each point and along each axis
// of colour.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/refinement/mixed_pixel_model.hpp"
#include "matching/refinement/mixed_pixel_sample.hpp"

namespace mbncc::refinement {

class MixedPixelEquations {
 public:
  static constexpr int kAxes = MixedPixelModel::kChannels, kMotion = 3;
  using Light = std::array<double, MixedPixelModel::kLight>;

  explicit MixedPixelEquations(const MixedPixelModel& object);

  /// Sets the observation to be explained by light and motion.
  void read(const MixedPixelSample& reading);
  /// Derivatives of the observation by x, y and rotation [per px, at the rim]: differences between
  /// `low` and `high`, read a pixel apart.
  void set_slope(int motion, const MixedPixelSample& low, const MixedPixelSample& high);

  /// Weights of all values, 1 at first.
  std::vector<float>& weights() { return weights_; }
  const std::vector<float>& weights() const { return weights_; }

  /// The light that best explains the observation, without motion ...
  Light light() const;
  /// ... and the motion [px, at the rim] that best explains it, together with its own light.
  cv::Vec3d motion() const;

  /// Residual after the light, per axis and point.
  void subtract(const Light& light, std::vector<float>& residual) const;

 private:
  // Rows of an axis: terms of light, observation, slopes.
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

}  // namespace mbncc::refinement
