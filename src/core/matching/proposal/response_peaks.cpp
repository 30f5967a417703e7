// SPDX-License-Identifier: BSD-3-Clause
#include "matching/proposal/response_peaks.hpp"

#include <algorithm>

namespace mbncc::proposal {

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
      labels_(best_.size(), 0) {}

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
  std::int16_t* best = &best_[(kKept + row) * width_];
  for (int x = 0; x < width_; ++x)
    if (wanted[x] == 0) best[x] = 0;
}

void PeakFinder::add_peaks(std::int16_t least, int y, std::vector<ResponsePeak>& peaks) {
  for (int row = 1; row <= kBand; ++row)
    for (int x = 0; x < width_; ++x) {
      const int i = row * width_ + x;
      if (best_[i] >= least && is_peak(i, x))
        peaks.emplace_back(best_[i], labels_[i], x, y - kKept + row);
    }
}

bool PeakFinder::is_peak(int i, int x) const {
  for (int above = i - width_; above <= i + width_; above += width_)
    for (int dx = x > 0 ? -1 : 0; dx <= (x + 1 < width_ ? 1 : 0); ++dx)
      if (best_[above + dx] > best_[i]) return false;
  return true;
}

}  // namespace mbncc::proposal
