// SPDX-License-Identifier: BSD-3-Clause
#include "matching/refinement/illumination_bias.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc::refinement {
namespace {

/// Standard deviation of the displacement by light: `even` [px] in even light, combined with
/// `share` of the displacement by shading.
struct BiasModel {
  double even, share;

  double variance(double shading) const { return even * even + share * share * shading; }
  double deviation(double shading) const { return std::hypot(even, share * std::sqrt(shading)); }
};
constexpr BiasModel kBrightness{0.005, 0.075}, kContour{0.03, 0.17};
constexpr BiasModel kPlace{0.002, 0.12}, kRim{0.003, 0.05};

constexpr double kPlain = 1;    // [grey^2 / px^2] bounds the displacement of plain surfaces
constexpr double kEven = 0.03;  // [px^2] shading of even light, which displaces nothing

}  // namespace

IlluminationBias::IlluminationBias(const templates::SurfaceTemplate& surface,
                                   const templates::SurfaceSample& seen, double contrast) {
  const double difference = surface.shading_difference(seen, contrast);
  const double slope =
      (surface.slope_product(0, 0) + surface.slope_product(1, 1)) /
      (2 * templates::SurfaceTemplate::kChannels * static_cast<double>(surface.size()));
  shading_ = std::max(0.0, difference / (contrast * contrast) / (slope + kPlain) - kEven);
}

double IlluminationBias::of_brightness() const {
  return kBrightness.deviation(shading_);
}

double IlluminationBias::of_contour() const {
  return kContour.deviation(shading_);
}

cv::Matx33d IlluminationBias::of_pose(double radius) const {
  const double place = kPlace.variance(shading_);
  return cv::Matx33d::diag({place, place, kRim.variance(shading_) / (radius * radius)});
}

}  // namespace mbncc::refinement
