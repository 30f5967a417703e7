#include "matching/kernels.hpp"

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

}  // namespace

const Table& reference() {
  static const Table table{correlate_reference, sum_runs_reference};
  return table;
}

}  // namespace mbncc::kernels
