// SPDX-License-Identifier: BSD-3-Clause
// Rectangle arithmetic that OpenCV lacks.
#pragma once

#include <opencv2/imgproc.hpp>

namespace mbncc::imaging {

/// `rect` with `margin` pixels added on every side.
inline cv::Rect grown(const cv::Rect& rect, int margin) {
  return {rect.x - margin, rect.y - margin, rect.width + 2 * margin, rect.height + 2 * margin};
}

/// Bounding box of a component, from the statistics of cv::connectedComponentsWithStats.
inline cv::Rect box_of_component(const cv::Mat& stats, int label) {
  const int* values = stats.ptr<int>(label);
  return {values[cv::CC_STAT_LEFT], values[cv::CC_STAT_TOP], values[cv::CC_STAT_WIDTH],
          values[cv::CC_STAT_HEIGHT]};
}

}  // namespace mbncc::imaging
