// SPDX-License-Identifier: BSD-3-Clause
// A padded grey image for the coarse search by correlation.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace mbncc::imaging {

/// The image with replicated borders for the kernels, and running sums along its rows.
class PaddedImage {
 public:
  /// `grey` is CV_8UC1. Reuses the memory of the previous image.
  void fill(const cv::Mat& grey, int margin);

  int margin() const { return margin_; }
  int stride() const { return stride_; }

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y + margin_) * stride_ + x + margin_;
  }

  std::vector<std::int16_t> pixels;         ///< minus a middle grey, to fit the kernels' range
  std::vector<std::int32_t> sums, squares;  ///< of the pixels to the left of each

 private:
  void fill_row(const uchar* row, std::size_t start);

  int margin_ = 0, stride_ = 0;
};

}  // namespace mbncc::imaging
