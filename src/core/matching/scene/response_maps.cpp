// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scene/response_maps.hpp"

#include <algorithm>
#include <array>

#include "simd/kernels.hpp"

namespace mbncc::scene {
namespace {

constexpr int kOrientations = ResponseMaps::kOrientations;
constexpr std::int8_t kUnseen = 7;  // response beyond the border, for partly visible objects

/// Responses of three adjacent rows before spreading, extended beyond the border by at least a
/// pixel.
class ResponseRows {
 public:
  explicit ResponseRows(const cv::Mat& edges) : edges_(edges) {
    for (auto& row : rows_)
      for (auto& responses : row) responses.resize(edges.cols + 4);
    read(0);
  }

  /// Advances to the rows around `y`, row by row.
  void move_to(int y) {
    if (y + 1 < edges_.rows) read(y + 1);
    y_ = y;
  }

  /// The row above, the row itself and the one below.
  std::array<const std::int8_t*, 3> around(int orientation) const {
    return {row(orientation, std::max(0, y_ - 1)), row(orientation, y_),
            row(orientation, std::min(edges_.rows - 1, y_ + 1))};
  }

 private:
  static constexpr int kHalf = kOrientations / 2;

  const std::int8_t* row(int orientation, int y) const {
    return rows_[y % rows_.size()][orientation].data() + 1;
  }

  void read(int y) {
    auto& all = rows_[y % rows_.size()];
    std::int8_t* first[kHalf];
    for (int k = 0; k < kHalf; ++k) first[k] = all[k].data() + 1;
    kernels::edge_responses(edges_.ptr<std::int8_t>(y), first, edges_.cols);
    for (auto* row : first) {
      row[-1] = row[0];
      std::fill(row + edges_.cols, row + edges_.cols + 3, row[edges_.cols - 1]);
    }
    // A quarter turn inverts the response of an edge.
    for (int k = 0; k < kHalf; ++k)
      std::transform(all[k].begin(), all[k].end(), all[k + kHalf].begin(),
                     [](std::int8_t response) { return static_cast<std::int8_t>(-response); });
  }

  const cv::Mat& edges_;
  int y_ = 0;
  std::array<std::array<std::vector<std::int8_t>, kOrientations>, 3> rows_;
};

}  // namespace

void ResponseMaps::fill(const cv::Mat& edges, int margin) {
  make_room(edges.size(), margin);
  ResponseRows rows(edges);
  for (int y = 0; y < edges.rows; ++y) {
    rows.move_to(y);
    for (int k = 0; k < kOrientations; ++k) {
      std::int8_t* even = &values_[offset(k, 0, y)];
      std::int8_t* odd = &values_[offset(k, 1, y)];
      kernels::spread_rows(rows.around(k).data(), even, odd, edges.cols / kStep);
      if (edges.cols % kStep != 0) even[edges.cols / kStep] = even[edges.cols / kStep - 1];
    }
  }
}

/// Keeps the padding if it suffices, because it does not change between images.
void ResponseMaps::make_room(cv::Size size, int margin) {
  if (size == size_ && margin <= margin_) return;
  size_ = {};  // until there is room: memory may run out
  stride_ = (size.width + 1) / kStep + margin + 1;
  plane_ = stride_ * ((size.height + 1) / kStep + margin + kernels::kResponseRows);
  values_.assign(static_cast<std::size_t>(plane_) * kPhases * kOrientations + kernels::kPositions,
                 kUnseen);
  size_ = size;
  margin_ = margin;
}

}  // namespace mbncc::scene
