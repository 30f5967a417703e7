// SPDX-License-Identifier: BSD-3-Clause
// The sample of a surface in a simulated image.
#pragma once

#include <algorithm>
#include <cstddef>

#include "matching/template/surface_template.hpp"

namespace mbncc::test {

/// Samples the whole surface; `light` maps the template's colour at x, y [px] to that of the image.
template <class Light>
templates::SurfaceSample sample_of(const templates::SurfaceTemplate& surface, const Light& light) {
  templates::SurfaceSample sample;
  sample.inside.assign(surface.padded(), 0.f);
  std::fill_n(sample.inside.begin(), surface.size(), 1.f);
  for (std::size_t c = 0; c < sample.planes.size(); ++c) {
    sample.planes[c].assign(surface.padded(), 0.f);
    for (std::size_t i = 0; i < surface.size(); ++i)
      sample.planes[c][i] = light(surface.planes[c][i], surface.x[i], surface.y[i]);
  }
  sample.points = sample.visible = surface.size();
  return sample;
}

}  // namespace mbncc::test
