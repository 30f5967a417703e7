// SPDX-License-Identifier: BSD-3-Clause
#include "learning/segmentation/half_smoothness.hpp"

#include <cstddef>

namespace mbncc::segmentation {
namespace {

cv::Size half_size(const cv::Size& size) {
  return {(size.width + 1) / 2, (size.height + 1) / 2};
}

// The edge between 2 x 2 blocks to which an edge between pixels belongs; none inside a block.
struct BlockEdge {
  int direction = -1;  // index of Smoothness::weights
  int owner = 0;       // columns from the pixel's block to the one that owns the edge
};

// Block edge of the edge in direction `k` of a pixel in an odd or even column and row. The later
// block in row-major order owns it.
BlockEdge block_edge(std::size_t k, int odd_column, int odd_row) {
  // Halves and rounds down; the offsets make this correct for negative numbers.
  cv::Point step((odd_column + Smoothness::kDx[k] + 2) / 2 - 1,
                 (odd_row + Smoothness::kDy[k] + 2) / 2 - 1);
  BlockEdge edge;
  if (step.y == 0 && step.x > 0) {
    edge.owner = step.x;
    step.x = -step.x;
  }
  for (int direction = 0; direction < static_cast<int>(Smoothness::kDx.size()); ++direction)
    if (step == cv::Point(Smoothness::kDx[direction], Smoothness::kDy[direction]))
      edge.direction = direction;
  return edge;
}

// Adds the edges of one direction that start in a row's even columns (`odd` 0) or odd columns
// (`odd` 1).
void add_row(const float* weights, int width, int odd, const BlockEdge& edge, Smoothness& half,
             int half_y) {
  if (edge.direction < 0) return;
  auto* sums = half.weights[edge.direction].ptr<float>(half_y);
  for (int x = odd; x < width; x += 2)
    if (weights[x] > 0) sums[x / 2 + edge.owner] += weights[x];
}

}  // namespace

cv::Mat half_resolution(const cv::Mat& unary) {
  cv::Mat half = cv::Mat::zeros(half_size(unary.size()), CV_32FC1);
  for (int y = 0; y < unary.rows; ++y) {
    const auto* own = unary.ptr<float>(y);
    auto* sums = half.ptr<float>(y / 2);
    for (int x = 0; x < unary.cols; ++x) sums[x / 2] += own[x];
  }
  return half;
}

Smoothness half_resolution(const Smoothness& smoothness) {
  const cv::Size size = smoothness.weights[0].size();
  Smoothness half;
  half.strength = 2 * smoothness.strength;
  for (auto& weights : half.weights) weights = cv::Mat::zeros(half_size(size), CV_32FC1);
  for (std::size_t k = 0; k < smoothness.weights.size(); ++k)
    for (int y = 0; y < size.height; ++y)
      for (const int odd : {0, 1})
        add_row(smoothness.weights[k].ptr<float>(y), size.width, odd, block_edge(k, odd, y % 2),
                half, y / 2);
  return half;
}

}  // namespace mbncc::segmentation
