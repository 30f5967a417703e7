// Rectangle arithmetic that OpenCV lacks.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// `rect` with `margin` pixels added on every side.
inline cv::Rect grown(const cv::Rect& rect, int margin) {
  return {rect.x - margin, rect.y - margin, rect.width + 2 * margin, rect.height + 2 * margin};
}

}  // namespace mbncc
