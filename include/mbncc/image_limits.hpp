// SPDX-License-Identifier: BSD-3-Clause
// Size limits of all images: in messages, files and object descriptions.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace mbncc {

struct ImageLimits {
  static constexpr int kMostSide = 16384;                  ///< [px]
  static constexpr std::int64_t kMostPixels = 64'000'000;  ///< 192 MB in colour

  static bool hold(cv::Size size) {
    return size.width > 0 && size.height > 0 && size.width <= kMostSide &&
           size.height <= kMostSide && std::int64_t{size.width} * size.height <= kMostPixels;
  }
};

}  // namespace mbncc
