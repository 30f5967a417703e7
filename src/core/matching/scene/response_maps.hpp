// SPDX-License-Identifier: BSD-3-Clause
// Response maps of an image's edges for each orientation, for the contour search (LINE-MOD).
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace mbncc::scene {

/// Response maps per orientation, spread to the neighbouring pixels and padded. Each is stored as
/// four maps of every second pixel, so that adjacent search positions are adjacent in memory.
class ResponseMaps {
 public:
  static constexpr int kOrientations = 8;  ///< number of orientations in a half turn
  static constexpr int kStep = 2;  ///< [px] between positions: responses are spread by one pixel

  /// `edges`: see smooth_and_find_edges(). `margin` [px] must be even. Reuses the memory of the
  /// last call, and keeps its margin if the size is the same and the margin was larger.
  void fill(const cv::Mat& edges, int margin);

  int margin() const { return margin_; }
  /// Index difference from a search position to the one below.
  int stride() const { return stride_; }
  const std::int8_t* data() const { return values_.data(); }

  /// Index of the response at a pixel. For a pixel p with even coordinates, offset(k, p + d) -
  /// offset(0, p) is offset(k, d) - offset(0, 0).
  std::int32_t offset(int orientation, int x, int y) const {
    const int column = x + margin_, row = y + margin_;
    const int phase = kStep * (row % kStep) + column % kStep;
    return (orientation * kPhases + phase) * plane_ + row / kStep * stride_ + column / kStep;
  }

 private:
  static constexpr int kPhases = kStep * kStep;

  void make_room(cv::Size size, int margin);

  cv::Size size_;
  int margin_ = 0, stride_ = 0, plane_ = 0;
  std::vector<std::int8_t> values_;
};

}  // namespace mbncc::scene
