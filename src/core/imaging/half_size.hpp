// SPDX-License-Identifier: BSD-3-Clause
// Images at half their size.
#pragma once

#include <opencv2/imgproc.hpp>

namespace mbncc::imaging {

/// Rounded sizes; `interpolation` is one of cv::InterpolationFlags.
inline cv::Mat half_size(const cv::Mat& image, int interpolation) {
  cv::Mat half;
  cv::resize(image, half, {}, 0.5, 0.5, interpolation);
  return half;
}

}  // namespace mbncc::imaging
