// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "simd/point_kernels.hpp"

namespace mbncc::kernels {
namespace {

struct Place {
  float x, y;
};

Place placed(const Points& points, int i, const Placement& at) {
  return {at.cosine * points.x[i] - at.sine * points.y[i] + at.x,
          at.sine * points.x[i] + at.cosine * points.y[i] + at.y};
}

Place turned(float x, float y, float cosine, float sine) {
  return {cosine * x - sine * y, sine * x + cosine * y};
}

float between(float from, float to, float part) {
  return from + part * (to - from);
}

float colour_at(const Image8& image, Place place, int channel) {
  const int column = static_cast<int>(place.x), row = static_cast<int>(place.y);
  const float fx = place.x - static_cast<float>(column), fy = place.y - static_cast<float>(row);
  const std::uint8_t* above = image.data + row * image.step + 3 * column + channel;
  const std::uint8_t* below = above + image.step;
  return between(between(above[0], above[3], fx), between(below[0], below[3], fx), fy);
}

void sample_colours_reference(const Image8& image, const Points& points, const Placement& placement,
                              const Colours& colours) {
  const float right = static_cast<float>(image.columns) - 1.01f;
  const float bottom = static_cast<float>(image.rows) - 1.01f;
  for (int i = 0; i < points.count; ++i) {
    const Place place = placed(points, i, placement);
    const bool inside = place.x >= 0 && place.y >= 0 && place.x <= right && place.y <= bottom;
    colours.inside[i] = inside ? 1 : 0;
    colours.blue[i] = inside ? colour_at(image, place, 0) : 0;
    colours.green[i] = inside ? colour_at(image, place, 1) : 0;
    colours.red[i] = inside ? colour_at(image, place, 2) : 0;
  }
}

void read_along_normals_reference(const Image8& image, const Points& points, const float* normal_x,
                                  const float* normal_y, const Placement& placement, int reach,
                                  const NormalReadings& readings) {
  for (int i = 0; i < points.count; ++i) {
    const Place place = placed(points, i, placement);
    const Place normal = turned(normal_x[i], normal_y[i], placement.cosine / placement.scale,
                                placement.sine / placement.scale);
    const float double_x = (normal.x * normal.x - normal.y * normal.y) / 127.f;
    const float double_y = 2.f * normal.x * normal.y / 127.f;
    float best = -2, weights = 0, moments = 0, strongest = 0;
    const int farthest = std::max(1, reach);
    for (int step = -farthest; step <= farthest; ++step) {
      const float x = place.x + static_cast<float>(step) * normal.x + 0.5f;
      const float y = place.y + static_cast<float>(step) * normal.y + 0.5f;
      if (x < 1 || y < 1 || x > static_cast<float>(image.columns) - 1.01f ||
          y > static_cast<float>(image.rows) - 1.01f)
        continue;
      const int column = static_cast<int>(x), row = static_cast<int>(y);
      const auto* edge =
          reinterpret_cast<const std::int8_t*>(image.data + row * image.step) + 2 * column;
      const float response = double_x * edge[0] + double_y * edge[1];
      if (std::abs(step) <= 1) best = std::max(best, response);
      const float offset = (static_cast<float>(column) - place.x) * normal.x +
                           (static_cast<float>(row) - place.y) * normal.y;
      const float positive = std::max(response, 0.f), square = positive * positive;
      weights += square;
      moments += square * offset;
      strongest = std::max(strongest, positive);
    }
    readings.seen[i] = best > -2 ? 1 : 0;
    readings.response[i] = best > -2 ? best : 0;
    if (reach == 0) continue;
    readings.pull[i] = strongest;
    readings.moment[i] = strongest * moments / (weights + 1e-12f);
  }
}

void edge_agreements_reference(const Image8& image, const Points& points, const float* direction_x,
                               const float* direction_y, const Placement& placement,
                               float* agreements) {
  const float x = placement.cosine / placement.scale, y = placement.sine / placement.scale;
  const float cosine = x * x - y * y, sine = 2.f * x * y;
  for (int i = 0; i < points.count; ++i) {
    const Place place = placed(points, i, placement);
    const Place direction = turned(direction_x[i], direction_y[i], cosine, sine);
    const int column =
        static_cast<int>(std::clamp(place.x + 0.5f, 0.f, static_cast<float>(image.columns - 1)));
    const int row =
        static_cast<int>(std::clamp(place.y + 0.5f, 0.f, static_cast<float>(image.rows - 1)));
    const auto* edge =
        reinterpret_cast<const std::int8_t*>(image.data + row * image.step) + 2 * column;
    agreements[i] = direction.x * edge[0] + direction.y * edge[1];
  }
}

void chroma_cells_reference(const ChromaCells& cells, const float* blue, const float* green,
                            const float* red, int count, std::int32_t* found) {
  const auto logarithm = [&](float colour) {
    return cells.logarithms[static_cast<int>(colour + 0.5f)];
  };
  const float scale = static_cast<float>(cells.side) / (2.f * cells.reach);
  const auto cell = [&](float value) {
    return std::clamp(static_cast<int>(std::floor((value + cells.reach) * scale)), 0,
                      cells.side - 1);
  };
  for (int i = 0; i < count; ++i) {
    const float reference = logarithm(green[i]);
    found[i] =
        cells.side * cell(logarithm(red[i]) - reference) + cell(logarithm(blue[i]) - reference);
  }
}

}  // namespace

const PointTable& point_reference() {
  static const PointTable table{sample_colours_reference, read_along_normals_reference,
                                edge_agreements_reference, chroma_cells_reference};
  return table;
}

}  // namespace mbncc::kernels
