// SPDX-License-Identifier: BSD-3-Clause
// The innermost loops of the search, on plain pointers. Every version of a kernel gives the same
// bits: integers, or floats added in a fixed order without fused multiply-add.
// MBNCC_KERNELS in the environment selects a target by name: reference (the formulas of
// kernels_reference.cpp), baseline, avx2 or avx512; by default, the last one that the machine
// supports is used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mbncc::kernels {

/// correlate() and best_responses() process whole groups of this many positions ...
constexpr int kPositions = 32;
/// ... and best_responses() processes this many rows of them.
constexpr int kResponseRows = 4;
/// Bounds on the input of correlate().
constexpr int kMaxImage = 128;
constexpr int kMaxWeight = 63;

/// sums[x] = sum_k weights[2 k] image[offsets[k] + x] + weights[2 k + 1] image[offsets[k] + x +
/// 1] for x in [0, count), `count` a multiple of kPositions. `pairs` is at most 2^16; |image| <=
/// kMaxImage, |weight| <= kMaxWeight.
void correlate(const std::int16_t* image, const std::int32_t* offsets, const std::int16_t* weights,
               int pairs, std::int32_t* sums, int count);

/// sums[x] = sum_r prefix[ends[r] + x] - prefix[begins[r] + x] for x in [0, count): sums over runs
/// of pixels, computed from running sums along the rows. The sums must fit into 31 bits.
void sum_runs(const std::int32_t* prefix, const std::int32_t* begins, const std::int32_t* ends,
              int runs, std::int32_t* sums, int count);

/// True when scale * values[x] > gates[x] for any x in [0, count).
bool any_above(const std::int32_t* values, float scale, const float* gates, int count);

/// Constants of normalise().
struct Normalisation {
  float scale;   ///< 1 / norm of the kernel's weights
  float pixels;  ///< number of the kernel's pixels
  float noise;   ///< [grey^2] added to the energy under the kernel
  float floor;   ///< lowest correlation of interest
};

/// With energy = squares[x] - sums[x]^2 / pixels + noise:
/// best[x] = max(best[x], scale numerators[x] / sqrt(energy)),
/// gates[x] = max(best[x], floor) sqrt(0.7 energy): what the next kernel must exceed.
void normalise(const std::int32_t* numerators, const std::int32_t* sums,
               const std::int32_t* squares, const Normalisation& terms, float* best, float* gates,
               int count);

/// Largest magnitude of a response map, so that a group of this many responses fits into 8 bits.
constexpr int kMaxResponse = 15;
constexpr int kTermGroup = 8;

/// Positions of the responses to an outline at several rotations.
struct ResponseTerms {
  const std::int32_t* offsets;  ///< rotations x count, relative to a position
  int count;                    ///< terms per rotation, at most 2000
  const std::int16_t* labels;   ///< of the rotations
  int rotations;
  int parts = 1;  ///< equal runs of a rotation's terms, of which the lowest is left out; 1: none is
};

/// best[y row_step + x] = max(0, sum_k maps[y stride + x + offsets[r count + k]] over the rotations
/// r), and labels is the label of the first rotation that attains this value (0 where none exceeds
/// 0), for x in [0, count), `count` a multiple of kPositions, y in [0, kResponseRows); |maps| <=
/// kMaxResponse. With several parts, the lowest part is left out of each sum.
void best_responses(const std::int8_t* maps, int stride, const ResponseTerms& terms,
                    std::int16_t* best, std::int16_t* labels, int row_step, int count);

/// Responses of `count` edge vectors (see gradient_orientation.hpp) to edges whose normals have
/// directions of 0, 1, 2 and 3 eighths of a half turn, scaled to kMaxResponse.
void edge_responses(const std::int8_t* edges, std::int8_t* const* responses, int count);

/// Maxima over a neighbourhood of one pixel in three adjacent rows: even[i] around pixel 2 i,
/// odd[i] around pixel 2 i + 1, for i in [0, count). The rows are read from -1 to 2 count.
void spread_rows(const std::int8_t* const* rows, std::int8_t* even, std::int8_t* odd, int count);

/// Symmetric smoothing in 256ths, weights[0] for the centre, [1] and [2] for the neighbours at
/// distances one and two; weights[0] + 2 weights[1] + 2 weights[2] = 256, none negative. First down
/// the columns of five rows, without rounding ...
void smooth_columns(const std::uint8_t* const* rows, const int* weights, std::uint16_t* sums,
                    int count);
/// ... then along the row, whose neighbours are 3 values apart (interleaved channels), with
/// rounding. `sums` is read from -6 to count + 6.
void smooth_along_row(const std::uint16_t* sums, const int* weights, std::uint8_t* smooth,
                      int count);

/// Sobel gradients of three adjacent rows of interleaved triples, read from -3 to count + 3, in
/// eighths of a level per pixel.
void slopes(const std::uint8_t* const* rows, std::int16_t* along_x, std::int16_t* along_y,
            int count);

/// For interleaved triples of gradients along x and y: out[2 i], out[2 i + 1] are those of the
/// channel with the largest magnitude (the first one of equals). |gradient| <= 1024.
void strongest_of_three(const std::int16_t* along_x, const std::int16_t* along_y, std::int16_t* out,
                        int count);

/// Gradient [eighths of a level per pixel] that gives half of the largest edge vector: kDarkEdge
/// where the image is black, and kEdgeContrast more per level of the brightest channel.
constexpr float kDarkEdge = 20, kEdgeContrast = 0.1f;

/// Edge vectors (see gradient_orientation.hpp) of `count` gradient pairs in eighths of a level,
/// at pixels of these colours (interleaved triples).
void edge_vectors(const std::int16_t* gradients, const std::uint8_t* colours, std::int8_t* edges,
                  int count);

/// Number of lanes in which dots() and dot_pairs() accumulate. The lanes are then added in halves:
/// the first eight plus the last eight, and so on. Vectors are padded with zeros to a multiple of
/// kLanes.
constexpr int kLanes = 16;

/// products[k] = sum_i rows[k stride + i] vector[i] for i in [0, count), k in [0, row_count).
/// `count` is a multiple of kLanes; rows may overlap.
void dots(const float* rows, std::size_t stride, int row_count, const float* vector, int count,
          float* products);

/// products[k] = sum_i a[k][i] b[k][i] for k in [0, pairs), i as in dots().
void dot_pairs(const float* const* a, const float* const* b, int pairs, int count, float* products);

/// One set of row kernels. To add a kernel: declare it above and add its entry here; put the loop
/// in a file that row_kernels.inc includes, and its entry there at the same position; add the call
/// in kernels.cpp, formula and entry in kernels_reference.cpp, a test in test/simd and a benchmark
/// in bench/kernels/kernels_bench.cpp.
struct Table {
  decltype(&correlate) correlate_row;
  decltype(&sum_runs) sum_runs_row;
  decltype(&any_above) any_above_row;
  decltype(&normalise) normalise_row;
  decltype(&best_responses) best_responses_rows;
  decltype(&edge_responses) edge_responses_row;
  decltype(&spread_rows) spread_rows_row;
  decltype(&smooth_columns) smooth_columns_row;
  decltype(&smooth_along_row) smooth_along_row_row;
  decltype(&slopes) slopes_row;
  decltype(&strongest_of_three) strongest_of_three_row;
  decltype(&edge_vectors) edge_vectors_row;
  decltype(&dots) dots_rows;
  decltype(&dot_pairs) dot_pairs_rows;
};

struct Target {
  const char* name;
  const Table* table;
};

/// The formulas as plain code.
const Table& reference();
/// The targets that this machine supports, the reference first, the fastest last.
const std::vector<Target>& targets();
/// The fastest target, or the one that the environment names. Throws std::invalid_argument if it
/// names one that is not among targets().
const Target& active();

}  // namespace mbncc::kernels
