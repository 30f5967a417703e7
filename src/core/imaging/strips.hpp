// SPDX-License-Identifier: BSD-3-Clause
// Processing by strips of rows: writing whole float images to memory would cost more than
// computing them.
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

namespace mbncc::imaging {

/// Calls use(cv::Range) for strips that make up `height` rows.
template <class Use>
void for_each_strip(int height, Use&& use) {
  constexpr int kStrip = 16;
  for (int y = 0; y < height; y += kStrip) use(cv::Range(y, std::min(y + kStrip, height)));
}

}  // namespace mbncc::imaging
