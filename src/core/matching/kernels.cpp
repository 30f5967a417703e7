#include "matching/kernels.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

// One function, compiled once per instruction set; the loader picks the version the machine has.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MBNCC_CLONES __attribute__((target_clones("default", "avx2", "arch=skylake-avx512")))
#else
#define MBNCC_CLONES
#endif

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

bool reference_wanted() {
  const char* wanted = std::getenv("MBNCC_KERNELS");
  return wanted != nullptr && std::strcmp(wanted, "reference") == 0;
}

}  // namespace

const Table& vectorised() {
  static const Table table{correlate_vectorised, sum_runs_vectorised};
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

}  // namespace mbncc::kernels
