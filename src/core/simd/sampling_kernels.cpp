// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "simd/clones.hpp"
#include "simd/point_groups.hpp"

namespace mbncc::kernels {
namespace {

// Pixels are read as whole words, unaligned.
using Word = std::uint32_t __attribute__((aligned(1), may_alias));

MBNCC_CLONES
void sample_group(const Image8& image, const float* __restrict px, const float* __restrict py,
                  int count, const Placement& placement, float* __restrict blue,
                  float* __restrict green, float* __restrict red, float* __restrict inside) {
  const float cosine = placement.cosine, sine = placement.sine, x0 = placement.x, y0 = placement.y;
  const float right = static_cast<float>(image.columns) - 1.01f;
  const float bottom = static_cast<float>(image.rows) - 1.01f;
  const int step = image.step;
  float fx[kGroup], fy[kGroup];
  std::int32_t at[kGroup];
  for (int i = 0; i < count; ++i) {
    const float x = cosine * px[i] - sine * py[i] + x0, y = sine * px[i] + cosine * py[i] + y0;
    const float inside_x = clamped(x, 0, right), inside_y = clamped(y, 0, bottom);
    const float in_x = inside_x == x ? 1.f : 0.f, in_y = inside_y == y ? 1.f : 0.f;
    const int column = static_cast<int>(inside_x), row = static_cast<int>(inside_y);
    inside[i] = in_x * in_y;
    fx[i] = inside_x - static_cast<float>(column);
    fy[i] = inside_y - static_cast<float>(row);
    at[i] = row * step + 3 * column;
  }
  std::uint32_t a[kGroup], b[kGroup], c[kGroup], d[kGroup];
  for (int i = 0; i < count; ++i) {
    const std::uint8_t* above = image.data + at[i];
    const std::uint8_t* below = above + step;
    // The right neighbour is read one byte early, so that no byte beyond the image is read.
    a[i] = *reinterpret_cast<const Word*>(above);
    b[i] = *reinterpret_cast<const Word*>(above + 2);
    c[i] = *reinterpret_cast<const Word*>(below);
    d[i] = *reinterpret_cast<const Word*>(below + 2);
  }
  const auto mix = [&](int shift, float* __restrict channel) {
    for (int i = 0; i < count; ++i) {
      const auto left_above = static_cast<float>(static_cast<int>(a[i] >> shift & 255));
      const auto right_above = static_cast<float>(static_cast<int>(b[i] >> (shift + 8) & 255));
      const auto left_below = static_cast<float>(static_cast<int>(c[i] >> shift & 255));
      const auto right_below = static_cast<float>(static_cast<int>(d[i] >> (shift + 8) & 255));
      const float top = left_above + fx[i] * (right_above - left_above);
      const float low = left_below + fx[i] * (right_below - left_below);
      channel[i] = inside[i] * (top + fy[i] * (low - top));
    }
  };
  mix(0, blue);
  mix(8, green);
  mix(16, red);
}

}  // namespace

void sample_colours_vectorised(const Image8& image, const Points& points,
                               const Placement& placement, const Colours& colours) {
  for (int k = 0; k < points.count; k += kGroup)
    sample_group(image, points.x + k, points.y + k, std::min(kGroup, points.count - k), placement,
                 colours.blue + k, colours.green + k, colours.red + k, colours.inside + k);
}

}  // namespace mbncc::kernels
