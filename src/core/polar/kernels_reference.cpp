#include "polar/kernels.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc::kernels {
namespace {

void correlate_reference(const std::int16_t* picture, const std::int32_t* offsets,
                         const std::int16_t* weights, int terms, std::int32_t* sums, int count) {
  for (int x = 0; x < count; ++x) {
    sums[x] = 0;
    for (int k = 0; k < terms; ++k) sums[x] += weights[k] * picture[offsets[k] + x];
  }
}

void sum_runs_reference(const std::int32_t* prefix, const std::int32_t* begins,
                        const std::int32_t* ends, int runs, std::int32_t* sums, int count) {
  for (int x = 0; x < count; ++x) {
    sums[x] = 0;
    for (int r = 0; r < runs; ++r) sums[x] += prefix[ends[r] + x] - prefix[begins[r] + x];
  }
}

bool any_above_reference(const std::int32_t* values, float scale, const float* gates, int count) {
  for (int x = 0; x < count; ++x)
    if (scale * static_cast<float>(values[x]) > gates[x]) return true;
  return false;
}

void normalise_reference(const std::int32_t* numerators, const std::int32_t* sums,
                         const std::int32_t* squares, const Normalisation& terms, float* best,
                         float* gates, int count) {
  const float scale = terms.scale, pixels = terms.pixels, noise = terms.noise, floor = terms.floor;
  for (int x = 0; x < count; ++x) {
    const float sum = static_cast<float>(sums[x]);
    const float energy = static_cast<float>(squares[x]) - sum * sum / pixels + noise;
    const float value = scale * static_cast<float>(numerators[x]) / std::sqrt(energy);
    best[x] = value > best[x] ? value : best[x];
    gates[x] = (best[x] > floor ? best[x] : floor) * std::sqrt(0.7f * energy);
  }
}

void sum_rows_max_reference(const std::int16_t* const* rows, int row_count, std::int16_t* sums,
                            std::int16_t* best, int count) {
  for (int x = 0; x < count; ++x) {
    int sum = 0;
    for (int k = 0; k < row_count; ++k) sum += rows[k][x];
    sums[x] = static_cast<std::int16_t>(sum);
    best[x] = std::max(best[x], sums[x]);
  }
}

void strongest_of_three_reference(const std::int16_t* along_x, const std::int16_t* along_y,
                                  std::int16_t* out, int count) {
  for (int i = 0; i < count; ++i) {
    int strongest = -1;
    for (int c = 3 * i; c < 3 * i + 3; ++c) {
      const int square = along_x[c] * along_x[c] + along_y[c] * along_y[c];
      if (square <= strongest) continue;
      strongest = square;
      out[2 * i] = along_x[c];
      out[2 * i + 1] = along_y[c];
    }
  }
}

void edge_vectors_reference(const std::int16_t* gradients, std::int8_t* edges, int count) {
  for (int i = 0; i < count; ++i) {
    const float x = gradients[2 * i], y = gradients[2 * i + 1];
    const float square = x * x + y * y;
    const float magnitude = std::sqrt(square);
    // kEdgeScale m / (m + 6) / m^2 with m in eighths; the small term keeps 0 / 0 away.
    const float scale = 127.f / ((magnitude + 48.f) * (magnitude + 1e-6f));
    edges[2 * i] = static_cast<std::int8_t>((x * x - y * y) * scale);
    edges[2 * i + 1] = static_cast<std::int8_t>(2.f * x * y * scale);
  }
}

void dots_reference(const float* rows, std::size_t stride, int row_count, const float* vector,
                    int count, float* products) {
  for (int k = 0; k < row_count; ++k) {
    float partial[kLanes] = {};
    for (int i = 0; i < count; ++i) partial[i % kLanes] += rows[k * stride + i] * vector[i];
    products[k] = 0;
    for (float sum : partial) products[k] += sum;
  }
}

}  // namespace

const Table& reference() {
  static const Table table{correlate_reference,    sum_runs_reference,
                           any_above_reference,    normalise_reference,
                           sum_rows_max_reference, strongest_of_three_reference,
                           edge_vectors_reference, dots_reference};
  return table;
}

}  // namespace mbncc::kernels
