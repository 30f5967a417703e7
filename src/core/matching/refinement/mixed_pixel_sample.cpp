// SPDX-License-Identifier: BSD-3-Clause
#include "matching/refinement/mixed_pixel_sample.hpp"

#include <algorithm>
#include <array>

#include "imaging/kernel_views.hpp"

namespace mbncc::refinement {
namespace {

constexpr int kChannels = MixedPixelModel::kChannels;

/// Colours at the first `count` points and whether they lie in the picture.
using Colours = std::array<std::vector<float>, kChannels + 1>;

kernels::Points first_of(const MixedPixelModel::SearchMask& places, std::size_t count) {
  return {places[0].data(), places[1].data(), static_cast<int>(count)};
}

/// Subtracts the share of the background from a channel of the mixed points.
void unmix(const float* __restrict part, const float* __restrict one, const float* __restrict other,
           const float* __restrict inside, std::size_t count, float* __restrict own) {
  for (std::size_t i = 0; i < count; ++i)
    own[i] = inside[i] * (own[i] - part[i] * (one[i] + other[i]));
}

}  // namespace

void read_rendering(const MixedPixelModel& object, const scene::SceneLevel& scene,
                    const Pose2D& pose, MixedPixelSample& reading) {
  const std::size_t padded = object.padded(), mixed = object.mixed;
  const kernels::Picture8 picture = imaging::view_of(scene.colour);
  const kernels::Placement placement = imaging::placement_of(pose);
  reading.values.resize(kChannels * padded);
  reading.inside.resize(padded);
  float* const own = reading.values.data();
  float* const inside = reading.inside.data();
  kernels::sample_colours(picture, first_of(object.points, padded), placement,
                          {own, own + padded, own + 2 * padded, inside});
  thread_local std::array<Colours, 2> beyond;
  for (int k = 0; k < 2; ++k) {
    for (auto& values : beyond[k]) values.resize(mixed);
    kernels::sample_colours(picture, first_of(object.beyond[k], mixed), placement,
                            {beyond[k][0].data(), beyond[k][1].data(), beyond[k][2].data(),
                             beyond[k][kChannels].data()});
  }
  thread_local std::vector<float> part;  // of each visible background
  part.resize(mixed);
  for (std::size_t i = 0; i < mixed; ++i) {
    const float seen = beyond[0][kChannels][i] + beyond[1][kChannels][i];
    part[i] = object.background[i] / std::max(1.f, seen);
    inside[i] = seen > 0 || object.background[i] == 0 ? inside[i] : 0.f;
  }
  for (int c = 0; c < kChannels; ++c)
    unmix(part.data(), beyond[0][c].data(), beyond[1][c].data(), inside, mixed, own + c * padded);
  MixedPixelModel::turn_to_axes(own, padded);
}

}  // namespace mbncc::refinement
