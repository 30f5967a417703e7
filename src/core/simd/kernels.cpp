// SPDX-License-Identifier: BSD-3-Clause
#include "simd/kernels.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#if defined(__x86_64__) && defined(__GNUC__)
#define MBNCC_X86 1
#include <immintrin.h>
#else
#define MBNCC_X86 0
#endif

namespace mbncc::kernels {
namespace {

#if MBNCC_X86

namespace baseline {
#define MBNCC_TARGET
#define MBNCC_LANES_16 8
#include "simd/row_kernels.inc"
#undef MBNCC_TARGET
#undef MBNCC_LANES_16
}  // namespace baseline

namespace avx2 {
#define MBNCC_TARGET __attribute__((target("avx2")))
#define MBNCC_LANES_16 16
#include "simd/row_kernels.inc"
#undef MBNCC_TARGET
#undef MBNCC_LANES_16
}  // namespace avx2

namespace avx512 {
#define MBNCC_TARGET __attribute__((target("avx2,avx512f,avx512bw,avx512vl")))
#define MBNCC_LANES_16 32
#include "simd/row_kernels.inc"
#undef MBNCC_TARGET
#undef MBNCC_LANES_16
}  // namespace avx512

bool has_avx2() {
  return __builtin_cpu_supports("avx2") != 0;
}

bool has_avx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512vl");
}

std::vector<Target> find_targets() {
  std::vector<Target> found{{"reference", &reference()}, {"baseline", &baseline::kTable}};
  if (has_avx2()) found.push_back({"avx2", &avx2::kTable});
  if (has_avx2() && has_avx512()) found.push_back({"avx512", &avx512::kTable});
  return found;
}

#else

namespace baseline {
#define MBNCC_TARGET
#define MBNCC_LANES_16 0
#include "simd/row_kernels.inc"
}  // namespace baseline

std::vector<Target> find_targets() {
  return {{"reference", &reference()}, {"baseline", &baseline::kTable}};
}

#endif

const Target& choose_target() {
  const char* wanted = std::getenv("MBNCC_KERNELS");
  if (wanted == nullptr) return targets().back();
  std::string known;
  for (const auto& target : targets()) {
    if (std::strcmp(wanted, target.name) == 0) return target;
    known += std::string(known.empty() ? "" : ", ") + target.name;
  }
  throw std::invalid_argument("MBNCC_KERNELS=" + std::string(wanted) +
                              " is unknown here; this machine has: " + known);
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all = find_targets();
  return all;
}

const Target& active() {
  static const Target& target = choose_target();
  return target;
}

void correlate(const std::int16_t* image, const std::int32_t* offsets, const std::int16_t* weights,
               int pairs, std::int32_t* sums, int count) {
  active().table->correlate_row(image, offsets, weights, pairs, sums, count);
}

void sum_runs(const std::int32_t* prefix, const std::int32_t* begins, const std::int32_t* ends,
              int runs, std::int32_t* sums, int count) {
  active().table->sum_runs_row(prefix, begins, ends, runs, sums, count);
}

bool any_above(const std::int32_t* values, float scale, const float* gates, int count) {
  return active().table->any_above_row(values, scale, gates, count);
}

void normalise(const std::int32_t* numerators, const std::int32_t* sums,
               const std::int32_t* squares, const Normalisation& terms, float* best, float* gates,
               int count) {
  active().table->normalise_row(numerators, sums, squares, terms, best, gates, count);
}

void best_responses(const std::int8_t* maps, int stride, const ResponseTerms& terms,
                    std::int16_t* best, std::int16_t* labels, int row_step, int count) {
  active().table->best_responses_rows(maps, stride, terms, best, labels, row_step, count);
}

void edge_responses(const std::int8_t* edges, std::int8_t* const* responses, int count) {
  active().table->edge_responses_row(edges, responses, count);
}

void spread_rows(const std::int8_t* const* rows, std::int8_t* even, std::int8_t* odd, int count) {
  active().table->spread_rows_row(rows, even, odd, count);
}

void smooth_columns(const std::uint8_t* const* rows, const int* weights, std::uint16_t* sums,
                    int count) {
  active().table->smooth_columns_row(rows, weights, sums, count);
}

void smooth_along_row(const std::uint16_t* sums, const int* weights, std::uint8_t* smooth,
                      int count) {
  active().table->smooth_along_row_row(sums, weights, smooth, count);
}

void slopes(const std::uint8_t* const* rows, std::int16_t* along_x, std::int16_t* along_y,
            int count) {
  active().table->slopes_row(rows, along_x, along_y, count);
}

void strongest_of_three(const std::int16_t* along_x, const std::int16_t* along_y, std::int16_t* out,
                        int count) {
  active().table->strongest_of_three_row(along_x, along_y, out, count);
}

void edge_vectors(const std::int16_t* gradients, const std::uint8_t* colours, std::int8_t* edges,
                  int count) {
  active().table->edge_vectors_row(gradients, colours, edges, count);
}

void dots(const float* rows, std::size_t stride, int row_count, const float* vector, int count,
          float* products) {
  active().table->dots_rows(rows, stride, row_count, vector, count, products);
}

void dot_pairs(const float* const* a, const float* const* b, int pairs, int count,
               float* products) {
  active().table->dot_pairs_rows(a, b, pairs, count, products);
}

}  // namespace mbncc::kernels
