// SPDX-License-Identifier: BSD-3-Clause
// Pictures worked on a few rows at a time: whole ones of floats would cost more to write to memory
// than to compute.
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

namespace mbncc {

/// Calls use(cv::Range) for strips that make up `height` rows.
template <class Use>
void for_each_strip(int height, Use&& use) {
  constexpr int kStrip = 16;
  for (int y = 0; y < height; y += kStrip) use(cv::Range(y, std::min(y + kStrip, height)));
}

}  // namespace mbncc
