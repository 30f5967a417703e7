#include "polar/kernels.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "polar/clones.hpp"

namespace mbncc::kernels {
namespace {

MBNCC_CLONES
void correlate_vectorised(const std::int16_t* __restrict picture,
                          const std::int32_t* __restrict offsets,
                          const std::int16_t* __restrict weights, int terms,
                          std::int32_t* __restrict sums, int count) {
  std::fill(sums, sums + count, 0);
  for (int k = 0; k < terms; k += kTermGroup) {
    const std::int16_t* __restrict a = picture + offsets[k];
    const std::int16_t* __restrict b = picture + offsets[k + 1];
    const std::int16_t* __restrict c = picture + offsets[k + 2];
    const std::int16_t* __restrict d = picture + offsets[k + 3];
    const std::int16_t wa = weights[k], wb = weights[k + 1], wc = weights[k + 2],
                       wd = weights[k + 3];
    for (int x = 0; x < count; ++x) {
      // Fits into 16 bits by the contract, which lets the compiler use 16-bit lanes.
      const auto group = static_cast<std::int16_t>(wa * a[x] + wb * b[x] + wc * c[x] + wd * d[x]);
      sums[x] += group;
    }
  }
}

MBNCC_CLONES
void sum_runs_vectorised(const std::int32_t* __restrict prefix,
                         const std::int32_t* __restrict begins, const std::int32_t* __restrict ends,
                         int runs, std::int32_t* __restrict sums, int count) {
  std::fill(sums, sums + count, 0);
  for (int r = 0; r < runs; ++r) {
    const std::int32_t* __restrict begin = prefix + begins[r];
    const std::int32_t* __restrict end = prefix + ends[r];
    for (int x = 0; x < count; ++x) sums[x] += end[x] - begin[x];
  }
}

MBNCC_CLONES
bool any_above_vectorised(const std::int32_t* values, float scale, const float* gates, int count) {
  int above = 0;
  for (int x = 0; x < count; ++x) above |= scale * static_cast<float>(values[x]) > gates[x];
  return above != 0;
}

MBNCC_CLONES
void normalise_vectorised(const std::int32_t* __restrict numerators,
                          const std::int32_t* __restrict sums,
                          const std::int32_t* __restrict squares, const Normalisation& terms,
                          float* __restrict best, float* __restrict gates, int count) {
  const float scale = terms.scale, pixels = terms.pixels, noise = terms.noise, floor = terms.floor;
  for (int x = 0; x < count; ++x) {
    const float sum = static_cast<float>(sums[x]);
    const float energy = static_cast<float>(squares[x]) - sum * sum / pixels + noise;
    const float value = scale * static_cast<float>(numerators[x]) / __builtin_sqrtf(energy);
    best[x] = value > best[x] ? value : best[x];
    gates[x] = (best[x] > floor ? best[x] : floor) * __builtin_sqrtf(0.7f * energy);
  }
}

MBNCC_CLONES
void sum_rows_max_vectorised(const std::int16_t* const* rows, int row_count,
                             std::int16_t* __restrict sums, std::int16_t* __restrict best,
                             int count) {
  std::fill(sums, sums + count, std::int16_t{0});
  int k = 0;
  for (; k + 4 <= row_count; k += 4) {
    const std::int16_t* __restrict a = rows[k];
    const std::int16_t* __restrict b = rows[k + 1];
    const std::int16_t* __restrict c = rows[k + 2];
    const std::int16_t* __restrict d = rows[k + 3];
    for (int x = 0; x < count; ++x)
      sums[x] = static_cast<std::int16_t>(sums[x] + a[x] + b[x] + c[x] + d[x]);
  }
  for (; k < row_count; ++k) {
    const std::int16_t* __restrict row = rows[k];
    for (int x = 0; x < count; ++x) sums[x] = static_cast<std::int16_t>(sums[x] + row[x]);
  }
  for (int x = 0; x < count; ++x) best[x] = std::max(best[x], sums[x]);
}

MBNCC_CLONES
void strongest_of_three_vectorised(const std::int16_t* __restrict along_x,
                                   const std::int16_t* __restrict along_y,
                                   std::int16_t* __restrict out, int count) {
  for (int i = 0; i < count; ++i) {
    const int c = 3 * i;
    const int x0 = along_x[c], x1 = along_x[c + 1], x2 = along_x[c + 2];
    const int y0 = along_y[c], y1 = along_y[c + 1], y2 = along_y[c + 2];
    const int square0 = x0 * x0 + y0 * y0, square1 = x1 * x1 + y1 * y1, square2 = x2 * x2 + y2 * y2;
    const bool second = square1 > square0;
    const int x01 = second ? x1 : x0, y01 = second ? y1 : y0;
    const bool third = square2 > (second ? square1 : square0);
    out[2 * i] = static_cast<std::int16_t>(third ? x2 : x01);
    out[2 * i + 1] = static_cast<std::int16_t>(third ? y2 : y01);
  }
}

MBNCC_CLONES
void edge_vectors_vectorised(const std::int16_t* __restrict gradients,
                             std::int8_t* __restrict edges, int count) {
  for (int i = 0; i < count; ++i) {
    const float x = gradients[2 * i], y = gradients[2 * i + 1];
    const float square = x * x + y * y;
    const float magnitude = __builtin_sqrtf(square);
    const float scale = 127.f / ((magnitude + 48.f) * (magnitude + 1e-6f));
    edges[2 * i] = static_cast<std::int8_t>((x * x - y * y) * scale);
    edges[2 * i + 1] = static_cast<std::int8_t>(2.f * x * y * scale);
  }
}

MBNCC_CLONES
void dots_vectorised(const float* __restrict rows, std::size_t stride, int row_count,
                     const float* __restrict vector, int count, float* __restrict products) {
  int k = 0;
  // Several rows at a time, so that additions need not wait for each other.
  for (; k + 4 <= row_count; k += 4) {
    const float* __restrict a = rows + k * stride;
    const float* __restrict b = a + stride;
    const float* __restrict c = b + stride;
    const float* __restrict d = c + stride;
    float partial[4][kLanes] = {};
    for (int i = 0; i < count; i += kLanes)
      for (int lane = 0; lane < kLanes; ++lane) {
        partial[0][lane] += a[i + lane] * vector[i + lane];
        partial[1][lane] += b[i + lane] * vector[i + lane];
        partial[2][lane] += c[i + lane] * vector[i + lane];
        partial[3][lane] += d[i + lane] * vector[i + lane];
      }
    for (int row = 0; row < 4; ++row) {
      float sum = 0;
      for (float part : partial[row]) sum += part;
      products[k + row] = sum;
    }
  }
  for (; k < row_count; ++k) {
    const float* __restrict row = rows + k * stride;
    float partial[kLanes] = {};
    for (int i = 0; i < count; i += kLanes)
      for (int lane = 0; lane < kLanes; ++lane) partial[lane] += row[i + lane] * vector[i + lane];
    float sum = 0;
    for (float part : partial) sum += part;
    products[k] = sum;
  }
}

bool reference_wanted() {
  const char* wanted = std::getenv("MBNCC_KERNELS");
  return wanted != nullptr && std::strcmp(wanted, "reference") == 0;
}

}  // namespace

const Table& vectorised() {
  static const Table table{correlate_vectorised,    sum_runs_vectorised,
                           any_above_vectorised,    normalise_vectorised,
                           sum_rows_max_vectorised, strongest_of_three_vectorised,
                           edge_vectors_vectorised, dots_vectorised};
  return table;
}

const Table& active() {
  static const Table& table = reference_wanted() ? reference() : vectorised();
  return table;
}

void correlate(const std::int16_t* picture, const std::int32_t* offsets,
               const std::int16_t* weights, int terms, std::int32_t* sums, int count) {
  active().correlate_row(picture, offsets, weights, terms, sums, count);
}

void sum_runs(const std::int32_t* prefix, const std::int32_t* begins, const std::int32_t* ends,
              int runs, std::int32_t* sums, int count) {
  active().sum_runs_row(prefix, begins, ends, runs, sums, count);
}

bool any_above(const std::int32_t* values, float scale, const float* gates, int count) {
  return active().any_above_row(values, scale, gates, count);
}

void normalise(const std::int32_t* numerators, const std::int32_t* sums,
               const std::int32_t* squares, const Normalisation& terms, float* best, float* gates,
               int count) {
  active().normalise_row(numerators, sums, squares, terms, best, gates, count);
}

void sum_rows_max(const std::int16_t* const* rows, int row_count, std::int16_t* sums,
                  std::int16_t* best, int count) {
  active().sum_rows_max_row(rows, row_count, sums, best, count);
}

void strongest_of_three(const std::int16_t* along_x, const std::int16_t* along_y, std::int16_t* out,
                        int count) {
  active().strongest_of_three_row(along_x, along_y, out, count);
}

void edge_vectors(const std::int16_t* gradients, std::int8_t* edges, int count) {
  active().edge_vectors_row(gradients, edges, count);
}

void dots(const float* rows, std::size_t stride, int row_count, const float* vector, int count,
          float* products) {
  active().dots_rows(rows, stride, row_count, vector, count, products);
}

}  // namespace mbncc::kernels
