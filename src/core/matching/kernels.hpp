// The innermost loops of the search, on plain pointers. Integer arithmetic only, so that every
// version of a kernel gives the same bits. MBNCC_KERNELS=reference in the environment selects the
// formulas of kernels_reference.cpp instead of the vectorised loops.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mbncc::kernels {

/// correlate() takes its terms in groups of this many; pad with weight 0 and offset 0.
constexpr int kTermGroup = 4;
/// Bounds of correlate(): a group's sum of products then fits into 16 bits.
constexpr int kMaxPicture = 128;
constexpr int kMaxWeight = 63;

/// sums[x] = sum_k weights[k] picture[offsets[k] + x] for x in [0, count).
/// `terms` is a multiple of kTermGroup and at most 2^17; |picture| <= kMaxPicture,
/// |weight| <= kMaxWeight.
void correlate(const std::int16_t* picture, const std::int32_t* offsets,
               const std::int16_t* weights, int terms, std::int32_t* sums, int count);

/// sums[x] = sum_r prefix[ends[r] + x] - prefix[begins[r] + x] for x in [0, count): totals over
/// runs of pixels from running sums along the rows. The totals must fit into 31 bits.
void sum_runs(const std::int32_t* prefix, const std::int32_t* begins, const std::int32_t* ends,
              int runs, std::int32_t* sums, int count);

using Correlate = decltype(&correlate);
using SumRuns = decltype(&sum_runs);

/// One set of kernels.
struct Table {
  Correlate correlate_row;
  SumRuns sum_runs_row;
};

/// The formulas, written down plainly.
const Table& reference();
/// The vectorised loops.
const Table& vectorised();
/// vectorised(), or reference() when the environment asks for it.
const Table& active();

}  // namespace mbncc::kernels
