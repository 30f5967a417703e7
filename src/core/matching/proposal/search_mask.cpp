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

std::vector<Span> covering_spans(const uchar* row, int count, int group) {
  std::vector<Span> spans;
  for (int x = 0; x < count; ++x) {
    if (row[x] == 0) continue;
    if (spans.empty() || x > spans.back().end) spans.push_back({x, x});
    while (spans.back().end <= x) spans.back().end += group;
    x = spans.back().end - 1;
  }
  // A last span that would end beyond the row starts earlier instead.
  if (!spans.empty() && spans.back().end > count) {
    const int length = spans.back().end - spans.back().begin;
    spans.back() = {std::max(0, count - length), std::max(count, length)};
  }
  return spans;
}

}  // namespace mbncc::proposal
