// SPDX-License-Identifier: BSD-3-Clause
// Finds peaks of the responses over a part of a contour's rotations.
#pragma once

#include <cstdint>
#include <vector>

#include "matching/proposal/contour_bank.hpp"
#include "matching/scene/response_maps.hpp"
#include "simd/kernels.hpp"

namespace mbncc::proposal {

/// A peak's position and rotation, packed so that sorted peaks are best first, then in the order of
/// rotations and places.
class ResponsePeak {
 public:
  ResponsePeak(int sum, int rotation, int x, int y)
      : packed_(std::uint64_t(kMost - sum) << 48 | std::uint64_t(rotation) << 32 |
                std::uint64_t(y) << 16 | std::uint64_t(x)) {}

  int sum() const { return kMost - static_cast<int>(packed_ >> 48); }
  int rotation() const { return static_cast<int>(packed_ >> 32 & kMost); }
  int y() const { return static_cast<int>(packed_ >> 16 & kMost); }
  int x() const { return static_cast<int>(packed_ & kMost); }

  bool operator<(const ResponsePeak& other) const { return packed_ < other.packed_; }

 private:
  static constexpr int kMost = 0xffff;

  std::uint64_t packed_;
};

/// Moves the best `count` peaks to the front, unordered, and returns their end.
std::vector<ResponsePeak>::iterator put_best_first(std::vector<ResponsePeak>& peaks,
                                                   std::size_t count);

/// Finds the best of a range of rotations at each position of a few rows. There is one finder per
/// range, because outlines often fit at several rotations that only the surface distinguishes.
class PeakFinder {
 public:
  static constexpr int kBand = kernels::kResponseRows;  ///< rows computed at a time

  /// `width`: number of positions per row. The points of a rotation are split into `parts`, of
  /// which the sums leave out the least; 1: none is left out.
  PeakFinder(int width, int parts);

  void add_rotation(const ContourBank::Rotation& rotation, std::size_t label,
                    const scene::ResponseMaps& maps);

  /// Advances to the next band; keeps the last rows of this one as its neighbours.
  void next_band();

  /// Sums the responses at `count` positions (whole groups) from `x` on in the rows of the band.
  /// `maps` points to the response at the first position.
  void sum_responses(const std::int8_t* maps, int stride, int x, int count);

  /// Clears positions outside the search: row `row` of the band where `wanted` is 0.
  void keep(int row, const std::uint8_t* wanted);

  /// Adds the positions with a sum of at least `least` that no neighbour exceeds, in the rows whose
  /// neighbours are known: from the row above the band to its last but one. `y` is the band's first
  /// row.
  void add_peaks(std::int16_t least, int y, std::vector<ResponsePeak>& peaks);

 private:
  static constexpr int kKept = 2;
  static constexpr int kRows = kKept + kBand;

  std::vector<std::int32_t> offsets_;              // of all points of the rotations
  std::vector<std::int16_t> labels_of_rotations_;  // indices of the rotations
  int width_, parts_, terms_ = 0;
  std::vector<std::int16_t> best_, labels_;  // kRows rows: largest sums and their rotations
  std::vector<std::int16_t> column_;         // largest of three rows, one more on each side
  std::vector<std::uint8_t> marked_;         // 1: peaks of a row
};

}  // namespace mbncc::proposal
