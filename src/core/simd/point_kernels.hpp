// SPDX-License-Identifier: BSD-3-Clause
// The innermost loops over the points of an object at a pose; kernels.hpp contains those over the
// rows of an image. Every version gives the same bits.
#pragma once

#include "simd/points.hpp"

namespace mbncc::kernels {

/// Interpolated colours of a three-channel image of at least 2 x 2 pixels.
void sample_colours(const Image8& image, const Points& points, const Placement& placement,
                    const Colours& colours);

/// Responses of an edge image (gradient_orientation.hpp) to edges across the unit normals, read at
/// whole pixels up to `reach` along them. At reach 0, only `response` and `seen` are written.
/// `image` has at least 3 x 3 pixels.
void read_along_normals(const Image8& image, const Points& points, const float* normal_x,
                        const float* normal_y, const Placement& placement, int reach,
                        const NormalReadings& readings);

/// agreements[i] = scalar product [edge scale] of direction i, rotated by twice the placement's
/// angle, with the edge vector nearest to point i; points outside the image are moved to its
/// border.
void edge_agreements(const Image8& image, const Points& points, const float* direction_x,
                     const float* direction_y, const Placement& placement, float* agreements);

/// cells[i] = side * cell(log[r] - log[g]) + cell(log[b] - log[g]) with
/// cell(v) = clamp(floor((v + reach) side / (2 reach)), 0, side - 1) and colours rounded to whole
/// numbers [0..255]. `logarithms` holds 256 values.
struct ChromaCells {
  const float* logarithms;
  float reach;
  int side;
};
void chroma_cells(const ChromaCells& cells, const float* blue, const float* green, const float* red,
                  int count, std::int32_t* found);

/// One set of point kernels.
struct PointTable {
  decltype(&sample_colours) sample_colours_at;
  decltype(&read_along_normals) read_along_normals_at;
  decltype(&edge_agreements) edge_agreements_at;
  decltype(&chroma_cells) chroma_cells_of;
};

/// The formulas as plain code.
const PointTable& point_reference();
/// The vectorised loops.
const PointTable& vectorised_points();

}  // namespace mbncc::kernels
