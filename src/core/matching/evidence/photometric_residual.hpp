// SPDX-License-Identifier: BSD-3-Clause
// The brightness of a surface, compared in the light that explains a picture best.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/template/surface_template.hpp"

namespace mbncc {

class PhotometricResidual {
 public:
  /// Nothing to compare.
  PhotometricResidual() = default;

  explicit PhotometricResidual(const SurfaceTemplate& surface);

  /// ln(rms [grey levels], 1 at least) of what a gain and smooth shading leave unexplained of a
  /// sample of that surface. Points in gloss, in shadow or covered count less, in the fit as in the
  /// result. 0 without anything to compare.
  double misfit(const SurfaceSample& sample) const;

 private:
  static constexpr int kTerms = ShadingBasis::kMostRows + 1;
  using Light = cv::Vec<double, kTerms>;

  std::size_t padded() const { return direction_[0].size(); }
  const float* term(int k) const { return &terms_[static_cast<std::size_t>(k) * padded()]; }
  void read_brightness(const SurfaceSample& sample, std::vector<float>& seen) const;
  Light light(const std::vector<float>& seen, const std::vector<float>& weights) const;
  void subtract(const Light& light, std::vector<float>& values) const;

  std::array<std::vector<float>, SurfaceTemplate::kChannels> direction_;  // unit, of b, g, r
  std::vector<float> terms_;  // rows of what light may show: smooth shading, then the template
  int count_ = 0;             // of them
  double points_ = 0;
};

}  // namespace mbncc
