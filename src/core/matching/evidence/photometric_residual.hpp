// SPDX-License-Identifier: BSD-3-Clause
// Photometric residual of a surface after a robust fit of gain and smooth shading.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/template/surface_template.hpp"

namespace mbncc::evidence {

class PhotometricResidual {
 public:
  /// Empty, without a surface.
  PhotometricResidual() = default;

  explicit PhotometricResidual(const templates::SurfaceTemplate& surface);

  /// ln(rms [grey levels], 1 at least) of the residual of a sample of that surface after a gain and
  /// smooth shading. Points in gloss, in shadow or covered have less weight, in the fit and in the
  /// result. 0 for an empty surface.
  double misfit(const templates::SurfaceSample& sample) const;

 private:
  static constexpr int kTerms = templates::ShadingBasis::kMostRows + 1;
  using Light = cv::Vec<double, kTerms>;

  std::size_t padded() const { return direction_[0].size(); }
  const float* term(int k) const { return &terms_[static_cast<std::size_t>(k) * padded()]; }
  void read_brightness(const templates::SurfaceSample& sample, std::vector<float>& seen) const;
  Light light(const std::vector<float>& seen, const std::vector<float>& weights) const;
  void subtract(const Light& light, std::vector<float>& values) const;

  std::array<std::vector<float>, templates::SurfaceTemplate::kChannels>
      direction_;             // unit, of b, g, r
  std::vector<float> terms_;  // rows of the light model: smooth shading, then the template
  int count_ = 0;             // of them
  double points_ = 0;
};

}  // namespace mbncc::evidence
