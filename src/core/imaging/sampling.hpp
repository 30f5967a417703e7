// SPDX-License-Identifier: BSD-3-Clause
// Bilinear reading of 8-bit images.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::imaging {

/// Interpolated grey value.
class GreySampler {
 public:
  explicit GreySampler(const cv::Mat& grey)
      : data_(grey.data), step_(grey.step), right_(grey.cols - 1), bottom_(grey.rows - 1) {}

  bool contains(float x, float y) const { return x >= 0 && y >= 0 && x <= right_ && y <= bottom_; }

  /// Value at a point inside the image.
  float operator()(float x, float y) const {
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const float fx = x - static_cast<float>(column), fy = y - static_cast<float>(row);
    const uchar* p = data_ + row * step_ + column;
    // On the last row or column, the neighbour beyond has weight 0 and is not read.
    const std::size_t right = static_cast<float>(column) < right_ ? 1 : 0;
    const std::size_t below = static_cast<float>(row) < bottom_ ? step_ : 0;
    const float top = p[0] + fx * (p[right] - p[0]);
    const float bottom = p[below] + fx * (p[below + right] - p[below]);
    return top + fy * (bottom - top);
  }

 private:
  const uchar* data_;
  std::size_t step_;
  float right_, bottom_;
};

/// Interpolated colour; false outside the image.
class ColourSampler {
 public:
  explicit ColourSampler(const cv::Mat& image)
      : data_(image.data),
        step_(image.step),
        right_(static_cast<float>(image.cols) - 1.01f),
        bottom_(static_cast<float>(image.rows) - 1.01f) {}

  bool operator()(float x, float y, float* colour) const {
    if (!(x >= 0 && y >= 0 && x < right_ && y < bottom_)) return false;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const float fx = x - static_cast<float>(column), fy = y - static_cast<float>(row);
    const uchar* above = data_ + row * step_ + 3 * column;
    const uchar* below = above + step_;
    for (int c = 0; c < 3; ++c) {
      const float top = above[c] + fx * (above[c + 3] - above[c]);
      const float bottom = below[c] + fx * (below[c + 3] - below[c]);
      colour[c] = top + fy * (bottom - top);
    }
    return true;
  }

 private:
  const uchar* data_;
  std::size_t step_;
  float right_, bottom_;
};

}  // namespace mbncc::imaging
