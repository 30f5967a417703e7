// The innermost loops of the search, on plain pointers. Every version of a kernel gives the same
// bits: integers, or floats added in a fixed order without fused multiply-add.
// MBNCC_KERNELS=reference in the environment selects the formulas of kernels_reference.cpp instead
// of the vectorised loops.
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

/// True when scale * values[x] > gates[x] for any x in [0, count).
bool any_above(const std::int32_t* values, float scale, const float* gates, int count);

/// Constants of normalise().
struct Normalisation {
  float scale;   ///< 1 / norm of the kernel's weights
  float pixels;  ///< of the kernel
  float noise;   ///< [grey^2] added to the energy under the kernel
  float floor;   ///< correlation that is of interest
};

/// With energy = squares[x] - sums[x]^2 / pixels + noise:
/// best[x] = max(best[x], scale numerators[x] / sqrt(energy)),
/// gates[x] = max(best[x], floor) sqrt(0.7 energy): what the next kernel must exceed.
void normalise(const std::int32_t* numerators, const std::int32_t* sums,
               const std::int32_t* squares, const Normalisation& terms, float* best, float* gates,
               int count);

/// sums[x] = sum_k rows[k][x] and best[x] = max(best[x], sums[x]) for x in [0, count). The sums
/// must fit into 16 bits.
void sum_rows_max(const std::int16_t* const* rows, int row_count, std::int16_t* sums,
                  std::int16_t* best, int count);

/// For interleaved triples of gradients along x and y: out[2 i], out[2 i + 1] are those of the
/// channel with the largest magnitude (the first of equals). |gradient| <= 1024.
void strongest_of_three(const std::int16_t* along_x, const std::int16_t* along_y, std::int16_t* out,
                        int count);

/// Edge vectors (see edge_picture.hpp) of `count` gradient pairs in eighths of a grey level.
void edge_vectors(const std::int16_t* gradients, std::int8_t* edges, int count);

/// Lanes in which dots() adds up; vectors are padded with zeros to a multiple of it.
constexpr int kLanes = 16;

/// products[k] = sum_i rows[k stride + i] vector[i] for i in [0, count), k in [0, row_count), added
/// up in kLanes partial sums. `count` is a multiple of kLanes; rows may overlap.
void dots(const float* rows, std::size_t stride, int row_count, const float* vector, int count,
          float* products);

using Correlate = decltype(&correlate);
using SumRuns = decltype(&sum_runs);
using AnyAbove = decltype(&any_above);
using Normalise = decltype(&normalise);
using SumRowsMax = decltype(&sum_rows_max);
using StrongestOfThree = decltype(&strongest_of_three);
using EdgeVectors = decltype(&edge_vectors);
using Dots = decltype(&dots);

/// One set of kernels.
struct Table {
  Correlate correlate_row;
  SumRuns sum_runs_row;
  AnyAbove any_above_row;
  Normalise normalise_row;
  SumRowsMax sum_rows_max_row;
  StrongestOfThree strongest_of_three_row;
  EdgeVectors edge_vectors_row;
  Dots dots_rows;
};

/// The formulas, written down plainly.
const Table& reference();
/// The vectorised loops.
const Table& vectorised();
/// vectorised(), or reference() when the environment asks for it.
const Table& active();

}  // namespace mbncc::kernels
