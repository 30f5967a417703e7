// SPDX-License-Identifier: BSD-3-Clause
#include "imaging/padded_image.hpp"

#include "simd/kernels.hpp"

namespace mbncc::imaging {

void PaddedImage::fill(const cv::Mat& grey, int margin) {
  margin_ = margin;
  stride_ = grey.cols + 2 * margin + 1;
  cv::Mat bordered;
  cv::copyMakeBorder(grey, bordered, margin, margin, margin, margin + 1, cv::BORDER_REPLICATE);
  const auto size = static_cast<std::size_t>(bordered.rows) * stride_;
  pixels.resize(size + kernels::kPositions);  // the kernels read whole groups
  sums.resize(size);
  squares.resize(size);
  for (int y = 0; y < bordered.rows; ++y)
    fill_row(bordered.ptr(y), static_cast<std::size_t>(y) * stride_);
}

void PaddedImage::fill_row(const uchar* row, std::size_t start) {
  constexpr int kMiddleGrey = 128;
  std::int32_t sum = 0, square = 0;
  for (int x = 0; x < stride_; ++x) {
    const int value = row[x] - kMiddleGrey;
    pixels[start + x] = static_cast<std::int16_t>(value);
    sums[start + x] = sum;
    squares[start + x] = square;
    sum += value;
    square += value * value;
  }
}

}  // namespace mbncc::imaging
