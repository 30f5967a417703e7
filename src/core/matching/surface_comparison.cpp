#include <algorithm>
#include <cmath>

#include "matching/padded_vectors.hpp"
#include "matching/picture_view.hpp"
#include "matching/surface_template.hpp"

namespace mbncc {

void SurfaceTemplate::sample(const SceneLevel& scene, const Pose2D& pose,
                             SurfaceSample& sample) const {
  for (auto* values : {&sample.planes[0], &sample.planes[1], &sample.planes[2], &sample.inside})
    values->resize(padded());
  kernels::sample_colours(view_of(scene.colour), {x.data(), y.data(), static_cast<int>(padded())},
                          placement_of(pose),
                          {sample.planes[0].data(), sample.planes[1].data(),
                           sample.planes[2].data(), sample.inside.data()});
  sample.points = size();
  sample.visible = static_cast<std::size_t>(product(sample.inside, sample.inside.data()) + 0.5);
  if (sample.visible == 0) return;
  for (int c = 0; c < kChannels; ++c) {
    sample.means[c] =
        product(sample.inside, sample.planes[c].data()) / static_cast<double>(sample.visible);
    if (sample.visible == size()) continue;
    for (std::size_t i = 0; i < size(); ++i)
      if (sample.inside[i] == 0) sample.planes[c][i] = static_cast<float>(sample.means[c]);
  }
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

SurfaceDifference SurfaceTemplate::difference(const SurfaceSample& sample, double gain) const {
  double rest = 0, shading = 0;
  for (int c = 0; c < kChannels; ++c) {
    std::vector<float> difference = sample.planes[c];
    subtract(difference, gain, planes[c].data());
    rest += product(difference, difference.data());
    float products[SurfaceTemplate::kMaxBasis];
    kernels::dots(basis.data(), padded(), basis_size, difference.data(), static_cast<int>(padded()),
                  products);
    for (int k = 0; k < basis_size; ++k) rest -= products[k] * products[k];
    for (int k = 1; k < basis_size; ++k) shading += products[k] * products[k];
  }
  const double values = kChannels * static_cast<double>(size());
  return {rest / values, shading / values};
}

double SurfaceTemplate::contrast(const SurfaceSample& sample) const {
  double common = 0;
  for (int c = 0; c < kChannels; ++c) common += product(projected[c], sample.planes[c].data());
  return common / std::max(projected_energy, 1e-6);
}

double SurfaceTemplate::mean_projected_energy() const {
  return projected_energy / (kChannels * static_cast<double>(size()));
}

}  // namespace mbncc
