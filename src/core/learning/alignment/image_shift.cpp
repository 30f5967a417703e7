// SPDX-License-Identifier: BSD-3-Clause
#include "learning/alignment/image_shift.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace mbncc::alignment {
namespace {

// Catmull-Rom kernel. Unlike OpenCV's cubic kernel, it shifts slopes by exactly `part` of a pixel.
cv::Mat cubic_kernel(double part) {
  const double t = part, tt = t * t, ttt = tt * t;
  return (cv::Mat_<float>(1, 4) << (-t + 2 * tt - ttt) / 2, (2 - 5 * tt + 3 * ttt) / 2,
          (t + 4 * tt - 3 * ttt) / 2, (ttt - tt) / 2);
}

}  // namespace

cv::Mat undo_shift(const cv::Mat& image, const cv::Point2d& shift) {
  const cv::Point whole(cvFloor(shift.x), cvFloor(shift.y));
  const int margin = std::max(std::abs(whole.x), std::abs(whole.y)) + 3;
  cv::Mat wide, moved;
  cv::copyMakeBorder(image, wide, margin, margin, margin, margin, cv::BORDER_REPLICATE);
  const cv::Mat shifted = wide(cv::Rect(whole + cv::Point(margin, margin), image.size()));
  cv::sepFilter2D(shifted, moved, -1, cubic_kernel(shift.x - whole.x),
                  cubic_kernel(shift.y - whole.y), {1, 1});
  return moved;
}

}  // namespace mbncc::alignment
