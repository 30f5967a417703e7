// SPDX-License-Identifier: BSD-3-Clause
#include "matching/proposal/response_peaks.hpp"

#include <algorithm>
#include <cstring>

#include "simd/clones.hpp"

namespace mbncc::proposal {
namespace {

/// Sets `marked` to 1 where a value of `row` is at least `least` and no neighbour exceeds it, else
/// to 0. The rows have `count` values, `columns` has `count` + 2.
MBNCC_CLONES
void mark_peaks(const std::int16_t* __restrict above, const std::int16_t* __restrict row,
                const std::int16_t* __restrict below, int count, std::int16_t least,
                std::int16_t* __restrict columns, std::uint8_t* __restrict marked) {
  for (int x = 0; x < count; ++x) {
    const std::int16_t vertical = above[x] > below[x] ? above[x] : below[x];
    columns[x + 1] = vertical > row[x] ? vertical : row[x];
  }
  for (int x = 0; x < count; ++x) {
    const std::int16_t beside = columns[x] > columns[x + 2] ? columns[x] : columns[x + 2];
    const std::int16_t around = beside > columns[x + 1] ? beside : columns[x + 1];
    marked[x] = row[x] >= (around > least ? around : least) ? 1 : 0;
  }
}

/// Sets the values of `row` to 0 where `wanted` is 0.
MBNCC_CLONES
void keep_wanted(const std::uint8_t* __restrict wanted, int count, std::int16_t* __restrict row) {
  for (int x = 0; x < count; ++x) row[x] = wanted[x] != 0 ? row[x] : std::int16_t{0};
}

}  // namespace

std::vector<ResponsePeak>::iterator put_best_first(std::vector<ResponsePeak>& peaks,
                                                   std::size_t count) {
  if (count >= peaks.size()) return peaks.end();
  const auto end = peaks.begin() + static_cast<std::ptrdiff_t>(count);
  std::nth_element(peaks.begin(), end, peaks.end());
  return end;
}

PeakFinder::PeakFinder(int width, int parts)
    : width_(width),
      parts_(parts),
      best_(static_cast<std::size_t>(kRows) * width, 0),
      labels_(best_.size(), 0),
      column_(width + 2, 0),
      marked_(width) {}

void PeakFinder::add_rotation(const ContourBank::Rotation& rotation, std::size_t label,
                              const scene::ResponseMaps& maps) {
  for (const auto& point : rotation.points)
    offsets_.push_back(maps.offset(point.orientation, point.x, point.y) - maps.offset(0, 0, 0));
  labels_of_rotations_.push_back(static_cast<std::int16_t>(label));
  terms_ = static_cast<int>(rotation.points.size());
}

void PeakFinder::next_band() {
  std::copy(best_.end() - kKept * width_, best_.end(), best_.begin());
  std::copy(labels_.end() - kKept * width_, labels_.end(), labels_.begin());
  std::fill(best_.begin() + kKept * width_, best_.end(), std::int16_t{0});
}

void PeakFinder::sum_responses(const std::int8_t* maps, int stride, int x, int count) {
  const int at = kKept * width_ + x;
  kernels::best_responses(maps, stride,
                          {offsets_.data(), terms_, labels_of_rotations_.data(),
                           static_cast<int>(labels_of_rotations_.size()), parts_},
                          &best_[at], &labels_[at], width_, count);
}

void PeakFinder::keep(int row, const std::uint8_t* wanted) {
  keep_wanted(wanted, width_, &best_[(kKept + row) * width_]);
}

void PeakFinder::add_peaks(std::int16_t least, int y, std::vector<ResponsePeak>& peaks) {
  for (int row = 1; row <= kBand; ++row) {
    const std::int16_t* best = &best_[row * width_];
    mark_peaks(best - width_, best, best + width_, width_, least, column_.data(), marked_.data());
    const std::uint8_t* const end = marked_.data() + width_;
    for (const std::uint8_t* at = marked_.data();
         (at = static_cast<const std::uint8_t*>(
              std::memchr(at, 1, static_cast<std::size_t>(end - at)))) != nullptr;
         ++at) {
      const auto x = static_cast<int>(at - marked_.data());
      const int i = row * width_ + x;
      peaks.emplace_back(best_[i], labels_[i], x, y - kKept + row);
    }
  }
}

}  // namespace mbncc::proposal
