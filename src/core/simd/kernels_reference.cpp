// SPDX-License-Identifier: BSD-3-Clause
#include "simd/kernels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace mbncc::kernels {
namespace {

void correlate_reference(const std::int16_t* image, const std::int32_t* offsets,
                         const std::int16_t* weights, int pairs, std::int32_t* sums, int count) {
  for (int x = 0; x < count; ++x) {
    sums[x] = 0;
    for (int k = 0; k < pairs; ++k)
      sums[x] +=
          weights[2 * k] * image[offsets[k] + x] + weights[2 * k + 1] * image[offsets[k] + x + 1];
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

void best_responses_reference(const std::int8_t* maps, int stride, const ResponseTerms& terms,
                              std::int16_t* best, std::int16_t* labels, int row_step, int count) {
  for (int y = 0; y < kResponseRows; ++y)
    for (int x = 0; x < count; ++x) {
      int highest = 0, label = 0;
      for (int r = 0; r < terms.rotations; ++r) {
        int sum = 0, least = std::numeric_limits<int>::max();
        for (int p = 0; p < terms.parts; ++p) {
          int part = 0;
          for (int k = terms.count * p / terms.parts; k < terms.count * (p + 1) / terms.parts; ++k)
            part += maps[y * stride + x + terms.offsets[r * terms.count + k]];
          sum += part;
          least = std::min(least, part);
        }
        if (terms.parts > 1) sum -= least;
        if (sum <= highest) continue;
        highest = sum;
        label = terms.labels[r];
      }
      best[y * row_step + x] = static_cast<std::int16_t>(highest);
      labels[y * row_step + x] = static_cast<std::int16_t>(label);
    }
}

/// Scale from edge vectors to responses in 1024ths: kMaxResponse / kEdgeScale, and that times
/// sqrt(1/2), rounded so that no response exceeds kMaxResponse.
constexpr int kAlong = 121, kDiagonal = 86;

void edge_responses_reference(const std::int8_t* edges, std::int8_t* const* responses, int count) {
  for (int x = 0; x < count; ++x) {
    const int c = edges[2 * x], s = edges[2 * x + 1];
    const int scaled[] = {c * kAlong, (c + s) * kDiagonal, s * kAlong, (s - c) * kDiagonal};
    for (int k = 0; k < 4; ++k) responses[k][x] = static_cast<std::int8_t>((scaled[k] + 512) >> 10);
  }
}

void spread_rows_reference(const std::int8_t* const* rows, std::int8_t* even, std::int8_t* odd,
                           int count) {
  const auto highest_about = [&](int x) {
    std::int8_t highest = -128;
    for (int row = 0; row < 3; ++row)
      for (int dx = -1; dx <= 1; ++dx) highest = std::max(highest, rows[row][x + dx]);
    return highest;
  };
  for (int i = 0; i < count; ++i) {
    even[i] = highest_about(2 * i);
    odd[i] = highest_about(2 * i + 1);
  }
}

void smooth_columns_reference(const std::uint8_t* const* rows, const int* weights,
                              std::uint16_t* sums, int count) {
  for (int x = 0; x < count; ++x) {
    int sum = 0;
    for (int k = -2; k <= 2; ++k) sum += weights[std::abs(k)] * rows[k + 2][x];
    sums[x] = static_cast<std::uint16_t>(sum);
  }
}

void smooth_along_row_reference(const std::uint16_t* sums, const int* weights, std::uint8_t* smooth,
                                int count) {
  for (int x = 0; x < count; ++x) {
    std::int64_t sum = 0;
    for (int k = -2; k <= 2; ++k) sum += weights[std::abs(k)] * std::int64_t{sums[x + 3 * k]};
    smooth[x] = static_cast<std::uint8_t>((sum + 32768) / 65536);
  }
}

void slopes_reference(const std::uint8_t* const* rows, std::int16_t* along_x, std::int16_t* along_y,
                      int count) {
  const int weights[] = {1, 2, 1};
  for (int x = 0; x < count; ++x) {
    along_x[x] = along_y[x] = 0;
    for (int k = 0; k < 3; ++k) {
      along_x[x] += static_cast<std::int16_t>(weights[k] * (rows[k][x + 3] - rows[k][x - 3]));
      along_y[x] += static_cast<std::int16_t>(
          weights[k] * (rows[2][x + 3 * (k - 1)] - rows[0][x + 3 * (k - 1)]));
    }
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

void edge_vectors_reference(const std::int16_t* gradients, const std::uint8_t* colours,
                            std::int8_t* edges, int count) {
  for (int i = 0; i < count; ++i) {
    const float x = gradients[2 * i], y = gradients[2 * i + 1];
    const float square = x * x + y * y;
    const float magnitude = std::sqrt(square);
    const int brightest = *std::max_element(colours + 3 * i, colours + 3 * i + 3);
    const float half = kDarkEdge + kEdgeContrast * static_cast<float>(brightest);
    // The small term avoids 0 / 0.
    const float scale = 127.f / ((magnitude + half) * (magnitude + 1e-6f));
    edges[2 * i] = static_cast<std::int8_t>((x * x - y * y) * scale);
    edges[2 * i + 1] = static_cast<std::int8_t>(2.f * x * y * scale);
  }
}

float dot(const float* a, const float* b, int count) {
  float partial[kLanes] = {};
  for (int i = 0; i < count; ++i) partial[i % kLanes] += a[i] * b[i];
  for (int lanes = kLanes / 2; lanes > 0; lanes /= 2)
    for (int lane = 0; lane < lanes; ++lane) partial[lane] += partial[lane + lanes];
  return partial[0];
}

void dots_reference(const float* rows, std::size_t stride, int row_count, const float* vector,
                    int count, float* products) {
  for (int k = 0; k < row_count; ++k) products[k] = dot(rows + k * stride, vector, count);
}

void dot_pairs_reference(const float* const* a, const float* const* b, int pairs, int count,
                         float* products) {
  for (int k = 0; k < pairs; ++k) products[k] = dot(a[k], b[k], count);
}

}  // namespace

const Table& reference() {
  static const Table table{
      correlate_reference,   sum_runs_reference,           any_above_reference,
      normalise_reference,   best_responses_reference,     edge_responses_reference,
      spread_rows_reference, smooth_columns_reference,     smooth_along_row_reference,
      slopes_reference,      strongest_of_three_reference, edge_vectors_reference,
      dots_reference,        dot_pairs_reference};
  return table;
}

}  // namespace mbncc::kernels
