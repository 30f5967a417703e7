// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "imaging/kernel_views.hpp"
#include "matching/template/surface_template.hpp"
#include "simd/clones.hpp"
#include "simd/lanes.hpp"

namespace mbncc::templates {

namespace {

/// Counts the points that are compared, and sets the others to their mean colour.
void fill_left_out(SurfaceSample& sample) {
  const float* counts = sample.inside.data();
  const auto [count, blue, green, red] = kernels::products<4>(
      {counts, counts, counts, counts},
      {counts, sample.planes[0].data(), sample.planes[1].data(), sample.planes[2].data()},
      sample.inside.size());
  sample.visible = static_cast<std::size_t>(count + 0.5);
  if (sample.visible == 0 || sample.visible == sample.points) return;
  const double sums[] = {blue, green, red};
  for (std::size_t c = 0; c < sample.planes.size(); ++c) {
    const auto mean = static_cast<float>(sums[c] / static_cast<double>(sample.visible));
    for (std::size_t i = 0; i < sample.points; ++i)
      if (sample.inside[i] == 0) sample.planes[c][i] = mean;
  }
}

/// Brightness (sum of the channels) over the points that are not saturated.
struct Exposure {
  float open = 0, saturated = 0;  // points
  float learned = 0, seen = 0;    // brightness of the open ones
};

MBNCC_CLONES
bool any_saturated(const float* __restrict blue, const float* __restrict green,
                   const float* __restrict red, const float* __restrict inside, std::size_t count) {
  int saturated = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const float darkest = std::min(blue[i], std::min(green[i], red[i]));
    saturated |= darkest >= kSaturated && inside[i] > 0 ? 1 : 0;
  }
  return saturated != 0;
}

Exposure exposure_of(const float* __restrict learned, const float* __restrict blue,
                     const float* __restrict green, const float* __restrict red,
                     const float* __restrict inside, std::size_t count) {
  Exposure all;
  for (std::size_t i = 0; i < count; ++i) {
    const float darkest = std::min(blue[i], std::min(green[i], red[i]));
    const float open = darkest < kSaturated ? inside[i] : 0.F;
    all.open += open;
    all.saturated += inside[i] - open;
    all.learned += open * learned[i];
    all.seen += open * (blue[i] + green[i] + red[i]);
  }
  return all;
}

}  // namespace

// The reflection of a lamp saturates the camera and shows nothing of the object. A point that is
// bright enough in the lesson may saturate in this light without a reflection.
void SurfaceTemplate::leave_out_highlights(SurfaceSample& sample) const {
  const auto& [blue, green, red] = sample.planes;
  if (!any_saturated(blue.data(), green.data(), red.data(), sample.inside.data(), padded())) return;
  const Exposure exposure = exposure_of(brightness.data(), blue.data(), green.data(), red.data(),
                                        sample.inside.data(), padded());
  if (exposure.open <= exposure.saturated) return;
  const float gain = exposure.seen / std::max(1.F, exposure.learned);
  for (std::size_t i = 0; i < size(); ++i) {
    const bool saturated = std::min({blue[i], green[i], red[i]}) >= kSaturated;
    if (saturated && gain * brightness[i] < kMaySaturate) sample.inside[i] = 0;
  }
}

void SurfaceTemplate::sample(const scene::PreparedPixels& pixels, const Pose2D& pose,
                             SurfaceSample& sample, double scale) const {
  for (auto* values : {&sample.planes[0], &sample.planes[1], &sample.planes[2], &sample.inside})
    values->resize(padded());
  kernels::sample_colours(imaging::view_of(pixels.colour),
                          {x.data(), y.data(), static_cast<int>(padded())},
                          imaging::placement_of(pose, scale),
                          {sample.planes[0].data(), sample.planes[1].data(),
                           sample.planes[2].data(), sample.inside.data()});
  sample.points = size();
  leave_out_highlights(sample);
  fill_left_out(sample);
}

SurfaceTemplate::Residual SurfaceTemplate::residual(const SurfaceSample& sample) const {
  const float *blue = sample.planes[0].data(), *green = sample.planes[1].data(),
              *red = sample.planes[2].data();
  const auto common =
      kernels::products<3>({projected[0].data(), projected[1].data(), projected[2].data()},
                           {blue, green, red}, padded());
  const auto energy = kernels::products<3>({blue, green, red}, {blue, green, red}, padded());
  float in_basis[ShadingBasis::kMostRows];
  Residual residual;
  for (int c = 0; c < kChannels; ++c) {
    residual.energy += energy[c];
    residual.common += common[c];
    basis.products(sample.planes[c].data(), in_basis);
    for (int k = 0; k < basis.size(); ++k) residual.energy -= in_basis[k] * in_basis[k];
  }
  residual.energy = std::max(0.0, residual.energy);
  return residual;
}

double SurfaceTemplate::correlation(const Residual& residual, double noise_variance) const {
  const double noise = kChannels * noise_variance * static_cast<double>(size());
  return residual.common / std::sqrt((residual.energy + noise) * (projected_energy + noise));
}

double SurfaceTemplate::unexplained(const Residual& residual) const {
  constexpr double kPrior = 20;  // [grey^2] pulls the gain of plain surfaces to 1
  const double count = kChannels * static_cast<double>(std::max<std::size_t>(1, size()));
  const double prior = kPrior * count;
  const double gain = std::clamp((residual.common + prior) / (projected_energy + prior), 0.65, 1.5);
  const double left = residual.energy - 2 * gain * residual.common + gain * gain * projected_energy;
  return std::max(0.0, left) / count;
}

double SurfaceTemplate::shading_difference(const SurfaceSample& sample, double gain) const {
  double shading = 0;
  for (int c = 0; c < kChannels; ++c) {
    std::vector<float> difference = sample.planes[c];
    kernels::subtract(difference, gain, planes[c].data());
    float products[ShadingBasis::kMostRows];
    basis.products(difference.data(), products);
    for (int k = 1; k < basis.size(); ++k) shading += products[k] * products[k];
  }
  return shading / (kChannels * static_cast<double>(size()));
}

double SurfaceTemplate::contrast(const SurfaceSample& sample) const {
  double common = 0;
  for (int c = 0; c < kChannels; ++c)
    common += kernels::product(projected[c], sample.planes[c].data());
  return common / std::max(projected_energy, 1e-6);
}

double SurfaceTemplate::mean_projected_energy() const {
  return projected_energy / (kChannels * static_cast<double>(size()));
}

}  // namespace mbncc::templates
