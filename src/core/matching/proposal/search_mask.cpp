// SPDX-License-Identifier: BSD-3-Clause
#include "matching/proposal/search_mask.hpp"

#include <algorithm>

namespace mbncc::proposal {

cv::Mat SearchMask::of_positions(int level, cv::Point first, int step, cv::Size count) const {
  cv::Mat positions(count, CV_8UC1, cv::Scalar(255));
  if (mask_.empty()) return positions;
  const auto cell = [&](int at, int most) {
    return std::min(((2 * at + 1) << level) >> (level_ + 1), most - 1);
  };
  for (int y = 0; y < count.height; ++y) {
    const uchar* cells = mask_.ptr(cell(first.y + step * y, mask_.rows));
    uchar* row = positions.ptr(y);
    for (int x = 0; x < count.width; ++x)
      row[x] = cells[cell(first.x + step * x, mask_.cols)] != 0 ? 255 : 0;
  }
  return positions;
}

}  // namespace mbncc::proposal
