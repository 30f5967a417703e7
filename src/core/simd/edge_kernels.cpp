// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "simd/clones.hpp"
#include "simd/point_groups.hpp"

namespace mbncc::kernels {
namespace {

// An edge vector: x and y, one signed byte each, unaligned.
using EdgeWord = std::uint16_t __attribute__((aligned(1), may_alias));

inline float x_of(std::uint32_t edge) {
  return static_cast<float>(static_cast<std::int32_t>(edge << 24) >> 24);
}

inline float y_of(std::uint32_t edge) {
  return static_cast<float>(static_cast<std::int32_t>(edge << 16) >> 24);
}

/// A group of contour points in read_along_normals().
struct NormalGroup {
  float x[kGroup], y[kGroup], normal_x[kGroup], normal_y[kGroup], double_x[kGroup],
      double_y[kGroup];
  float best[kGroup], weights[kGroup], moments[kGroup], strongest[kGroup];
};

MBNCC_CLONES
void place_normals(const float* __restrict px, const float* __restrict py,
                   const float* __restrict nx, const float* __restrict ny, int count,
                   const Placement& placement, NormalGroup& group) {
  const float cosine = placement.cosine, sine = placement.sine, x0 = placement.x, y0 = placement.y;
  const float turn_x = cosine / placement.scale, turn_y = sine / placement.scale;
  for (int i = 0; i < count; ++i) {
    group.x[i] = cosine * px[i] - sine * py[i] + x0;
    group.y[i] = sine * px[i] + cosine * py[i] + y0;
    const float x = turn_x * nx[i] - turn_y * ny[i], y = turn_y * nx[i] + turn_x * ny[i];
    group.normal_x[i] = x;
    group.normal_y[i] = y;
    group.double_x[i] = (x * x - y * y) / 127.f;
    group.double_y[i] = 2.f * x * y / 127.f;
    group.best[i] = -2;
    group.weights[i] = group.moments[i] = group.strongest[i] = 0;
  }
}

/// A pixel of an edge image.
struct Pixel {
  int column, row;  ///< moved to the image's border from outside
  float inside;     ///< 1 if it was inside, else 0
};

/// The pixel `step` pixels along the normal of point i.
inline Pixel pixel_along(const NormalGroup& group, int i, float step, const Image8& image) {
  const float right = static_cast<float>(image.columns) - 1.01f;
  const float bottom = static_cast<float>(image.rows) - 1.01f;
  const float x = group.x[i] + step * group.normal_x[i] + 0.5f;
  const float y = group.y[i] + step * group.normal_y[i] + 0.5f;
  const float inside_x = clamped(x, 1, right), inside_y = clamped(y, 1, bottom);
  const float in_x = inside_x == x ? 1.f : 0.f, in_y = inside_y == y ? 1.f : 0.f;
  return {static_cast<int>(inside_x), static_cast<int>(inside_y), in_x * in_y};
}

/// The responses `step` pixels along the normals.
MBNCC_CLONES
void read_responses(const Image8& image, int count, float step, NormalGroup& group) {
  const int stride = image.step;
  float inside[kGroup];
  std::int32_t at[kGroup];
  for (int i = 0; i < count; ++i) {
    const Pixel pixel = pixel_along(group, i, step, image);
    inside[i] = pixel.inside;
    at[i] = pixel.row * stride + 2 * pixel.column;
  }
  std::uint32_t edges[kGroup];
  for (int i = 0; i < count; ++i) edges[i] = *reinterpret_cast<const EdgeWord*>(image.data + at[i]);
  for (int i = 0; i < count; ++i) {
    const float response = group.double_x[i] * x_of(edges[i]) + group.double_y[i] * y_of(edges[i]);
    const float candidate = inside[i] > 0 ? response : -2.f;
    group.best[i] = group.best[i] > candidate ? group.best[i] : candidate;
  }
}

/// The same, with what pull and moment need. `near`: the reading counts for the best response.
MBNCC_CLONES
void read_pulls(const Image8& image, int count, float step, bool near, NormalGroup& group) {
  const int stride = image.step;
  float offset[kGroup], inside[kGroup];
  std::int32_t at[kGroup];
  for (int i = 0; i < count; ++i) {
    const Pixel pixel = pixel_along(group, i, step, image);
    inside[i] = pixel.inside;
    offset[i] = (static_cast<float>(pixel.column) - group.x[i]) * group.normal_x[i] +
                (static_cast<float>(pixel.row) - group.y[i]) * group.normal_y[i];
    at[i] = pixel.row * stride + 2 * pixel.column;
  }
  std::uint32_t edges[kGroup];
  for (int i = 0; i < count; ++i) edges[i] = *reinterpret_cast<const EdgeWord*>(image.data + at[i]);
  const float allowance = near ? 0.f : -4.f;
  for (int i = 0; i < count; ++i) {
    const float edge_x = x_of(edges[i]), edge_y = y_of(edges[i]);
    const float response = group.double_x[i] * edge_x + group.double_y[i] * edge_y;
    const float candidate = inside[i] > 0 ? response + allowance : -2.f;
    group.best[i] = group.best[i] > candidate ? group.best[i] : candidate;
    const float positive = inside[i] * (response > 0 ? response : 0.f);
    const float square = positive * positive;
    group.weights[i] += square;
    group.moments[i] += square * offset[i];
    group.strongest[i] = group.strongest[i] > positive ? group.strongest[i] : positive;
  }
}

MBNCC_CLONES
void report_responses(const NormalGroup& group, int count, float* __restrict response,
                      float* __restrict seen) {
  for (int i = 0; i < count; ++i) {
    seen[i] = group.best[i] > -2.f ? 1.f : 0.f;
    response[i] = group.best[i] > -2.f ? group.best[i] : 0.f;
  }
}

MBNCC_CLONES
void report_pulls(const NormalGroup& group, int count, float* __restrict pull,
                  float* __restrict moment) {
  for (int i = 0; i < count; ++i) {
    pull[i] = group.strongest[i];
    moment[i] = group.strongest[i] * group.moments[i] / (group.weights[i] + 1e-12f);
  }
}

MBNCC_CLONES
void edge_agreements_group(const Image8& image, const float* __restrict px,
                           const float* __restrict py, const float* __restrict dx,
                           const float* __restrict dy, int count, const Placement& placement,
                           float* __restrict agreements) {
  const float cosine = placement.cosine, sine = placement.sine, x0 = placement.x, y0 = placement.y;
  const float turn_x = cosine / placement.scale, turn_y = sine / placement.scale;
  const float double_cosine = turn_x * turn_x - turn_y * turn_y,
              double_sine = 2.f * turn_x * turn_y;
  const auto right = static_cast<float>(image.columns - 1);
  const auto bottom = static_cast<float>(image.rows - 1);
  const int stride = image.step;
  std::int32_t at[kGroup];
  std::uint32_t edges[kGroup];
  for (int i = 0; i < count; ++i) {
    const float x = cosine * px[i] - sine * py[i] + x0 + 0.5f;
    const float y = sine * px[i] + cosine * py[i] + y0 + 0.5f;
    const int column = static_cast<int>(clamped(x, 0, right));
    const int row = static_cast<int>(clamped(y, 0, bottom));
    at[i] = row * stride + 2 * column;
  }
  for (int i = 0; i < count; ++i) edges[i] = *reinterpret_cast<const EdgeWord*>(image.data + at[i]);
  for (int i = 0; i < count; ++i) {
    const float edge_x = x_of(edges[i]), edge_y = y_of(edges[i]);
    const float turned_x = double_cosine * dx[i] - double_sine * dy[i];
    const float turned_y = double_sine * dx[i] + double_cosine * dy[i];
    agreements[i] = turned_x * edge_x + turned_y * edge_y;
  }
}

}  // namespace

void read_along_normals_vectorised(const Image8& image, const Points& points, const float* normal_x,
                                   const float* normal_y, const Placement& placement, int reach,
                                   const NormalReadings& readings) {
  NormalGroup group;
  for (int k = 0; k < points.count; k += kGroup) {
    const int count = std::min(kGroup, points.count - k);
    place_normals(points.x + k, points.y + k, normal_x + k, normal_y + k, count, placement, group);
    if (reach == 0) {
      for (const float step : {-1.f, 0.f, 1.f}) read_responses(image, count, step, group);
    } else {
      for (int step = -reach; step <= reach; ++step)
        read_pulls(image, count, static_cast<float>(step), step >= -1 && step <= 1, group);
      report_pulls(group, count, readings.pull + k, readings.moment + k);
    }
    report_responses(group, count, readings.response + k, readings.seen + k);
  }
}

void edge_agreements_vectorised(const Image8& image, const Points& points, const float* direction_x,
                                const float* direction_y, const Placement& placement,
                                float* agreements) {
  for (int k = 0; k < points.count; k += kGroup)
    edge_agreements_group(image, points.x + k, points.y + k, direction_x + k, direction_y + k,
                          std::min(kGroup, points.count - k), placement, agreements + k);
}

}  // namespace mbncc::kernels
