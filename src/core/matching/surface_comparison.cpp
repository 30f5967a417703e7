#include <algorithm>
#include <cmath>

#include "matching/padded_vectors.hpp"
#include "matching/sampling.hpp"
#include "matching/surface_template.hpp"

namespace mbncc {

void SurfaceTemplate::sample(const SceneLevel& scene, const Pose2D& pose,
                             SurfaceSample& sample) const {
  const ColourSampler colour_at(scene.colour);
  const auto c = static_cast<float>(std::cos(pose.theta));
  const auto s = static_cast<float>(std::sin(pose.theta));
  const auto x0 = static_cast<float>(pose.x), y0 = static_cast<float>(pose.y);
  for (auto& plane : sample.planes) plane.assign(padded(), 0.f);
  sample.inside.assign(size(), 0);
  sample.visible = 0;
  std::array<float, 3> sums{};
  for (std::size_t i = 0; i < size(); ++i) {
    float colour[3];
    if (!colour_at(c * x[i] - s * y[i] + x0, s * x[i] + c * y[i] + y0, colour)) continue;
    sample.inside[i] = 1;
    ++sample.visible;
    for (int k = 0; k < kChannels; ++k) {
      sample.planes[k][i] = colour[k];
      sums[k] += colour[k];
    }
  }
  if (sample.visible == size() || sample.visible == 0) return;
  for (int k = 0; k < kChannels; ++k)
    for (std::size_t i = 0; i < size(); ++i)
      if (!sample.inside[i]) sample.planes[k][i] = sums[k] / static_cast<float>(sample.visible);
}

double SurfaceTemplate::projected_correlation(const SurfaceSample& sample,
                                              double noise_variance) const {
  const int count = static_cast<int>(padded());
  float products[SurfaceTemplate::kMaxBasis];
  double common = 0, energy = 0;
  for (int c = 0; c < kChannels; ++c) {
    const float* values = sample.planes[c].data();
    energy += product(sample.planes[c], values);
    common += product(projected[c], values);
    kernels::dots(basis.data(), padded(), basis_size, values, count, products);
    for (int k = 0; k < basis_size; ++k) energy -= products[k] * products[k];
  }
  const double noise = kChannels * noise_variance * static_cast<double>(size());
  return common / std::sqrt((std::max(0.0, energy) + noise) * (projected_energy + noise));
}

double SurfaceTemplate::projected_difference(const SurfaceSample& sample) const {
  double energy = 0;
  for (int c = 0; c < kChannels; ++c) {
    std::vector<float> difference = sample.planes[c];
    subtract(difference, 1, planes[c].data());
    energy += product(difference, difference.data());
    float products[SurfaceTemplate::kMaxBasis];
    kernels::dots(basis.data(), padded(), basis_size, difference.data(), static_cast<int>(padded()),
                  products);
    for (int k = 0; k < basis_size; ++k) energy -= products[k] * products[k];
  }
  return energy / (kChannels * static_cast<double>(size()));
}

double SurfaceTemplate::mean_projected_energy() const {
  return projected_energy / (kChannels * static_cast<double>(size()));
}

}  // namespace mbncc
