// SPDX-License-Identifier: BSD-3-Clause
#include "imaging/pyramid.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace mbncc::imaging {

std::vector<cv::Mat> build_pyramid(const cv::Mat& image, int top) {
  std::vector<cv::Mat> levels;
  build_pyramid(image, top, levels);
  return levels;
}

void build_pyramid(const cv::Mat& image, int top, std::vector<cv::Mat>& levels) {
  levels.resize(std::max<std::size_t>(levels.size(), top + 1));
  levels[0] = image;
  std::size_t count = 1;
  for (; count <= static_cast<std::size_t>(top); ++count) {
    const cv::Mat& below = levels[count - 1];
    const cv::Size half(below.cols / 2, below.rows / 2);
    if (half.width < kSmallestLevel || half.height < kSmallestLevel) break;
    cv::resize(below(cv::Rect(0, 0, 2 * half.width, 2 * half.height)), levels[count], half, 0, 0,
               cv::INTER_AREA);
  }
  levels.resize(count);
}

}  // namespace mbncc::imaging
