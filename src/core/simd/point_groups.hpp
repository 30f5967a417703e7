// SPDX-License-Identifier: BSD-3-Clause
// The vectorised kernels that read images at points; point_kernels.hpp documents them.
#pragma once

#include "simd/points.hpp"

namespace mbncc::kernels {

/// Points pass through the stages of a kernel in groups whose intermediate values stay in the
/// cache: the compiler can vectorise only the arithmetic before and after the reading of pixels.
constexpr int kGroup = 64;

/// `value` limited to [least, most].
inline float clamped(float value, float least, float most) {
  const float above = value > least ? value : least;
  return above < most ? above : most;
}

void sample_colours_vectorised(const Image8& image, const Points& points,
                               const Placement& placement, const Colours& colours);

void read_along_normals_vectorised(const Image8& image, const Points& points, const float* normal_x,
                                   const float* normal_y, const Placement& placement, int reach,
                                   const NormalReadings& readings);

void edge_agreements_vectorised(const Image8& image, const Points& points, const float* direction_x,
                                const float* direction_y, const Placement& placement,
                                float* agreements);

}  // namespace mbncc::kernels
