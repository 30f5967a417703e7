// SPDX-License-Identifier: BSD-3-Clause
#include "simd/point_kernels.hpp"

#include <algorithm>

#include "simd/clones.hpp"
#include "simd/kernels.hpp"
#include "simd/point_groups.hpp"

namespace mbncc::kernels {
namespace {

MBNCC_CLONES
void chroma_cells_vectorised(const ChromaCells& cells, const float* __restrict blue,
                             const float* __restrict green, const float* __restrict red, int count,
                             std::int32_t* __restrict found) {
  const float* __restrict logarithms = cells.logarithms;
  const float reach = cells.reach, scale = static_cast<float>(cells.side) / (2.f * cells.reach);
  const auto last = static_cast<float>(cells.side - 1);
  const int side = cells.side;
  for (int i = 0; i < count; ++i) {
    const float reference = logarithms[static_cast<int>(green[i] + 0.5f)];
    const float u = (logarithms[static_cast<int>(red[i] + 0.5f)] - reference + reach) * scale;
    const float v = (logarithms[static_cast<int>(blue[i] + 0.5f)] - reference + reach) * scale;
    found[i] = side * static_cast<int>(std::min(std::max(u, 0.f), last)) +
               static_cast<int>(std::min(std::max(v, 0.f), last));
  }
}

const PointTable& active_points() {
  static const PointTable& table =
      active().table == &reference() ? point_reference() : vectorised_points();
  return table;
}

}  // namespace

const PointTable& vectorised_points() {
  static const PointTable table{sample_colours_vectorised, read_along_normals_vectorised,
                                edge_agreements_vectorised, chroma_cells_vectorised};
  return table;
}

void sample_colours(const Image8& image, const Points& points, const Placement& placement,
                    const Colours& colours) {
  active_points().sample_colours_at(image, points, placement, colours);
}

void read_along_normals(const Image8& image, const Points& points, const float* normal_x,
                        const float* normal_y, const Placement& placement, int reach,
                        const NormalReadings& readings) {
  active_points().read_along_normals_at(image, points, normal_x, normal_y, placement, reach,
                                        readings);
}

void edge_agreements(const Image8& image, const Points& points, const float* direction_x,
                     const float* direction_y, const Placement& placement, float* agreements) {
  active_points().edge_agreements_at(image, points, direction_x, direction_y, placement,
                                     agreements);
}

void chroma_cells(const ChromaCells& cells, const float* blue, const float* green, const float* red,
                  int count, std::int32_t* found) {
  active_points().chroma_cells_of(cells, blue, green, red, count, found);
}

}  // namespace mbncc::kernels
