#include "mbncc/matching/pyramid.hpp"

#include <opencv2/imgproc.hpp>

namespace mbncc {

std::vector<cv::Mat> build_pyramid(const cv::Mat& picture, int top) {
  constexpr int kSmallest = 4;
  std::vector<cv::Mat> levels{picture};
  for (int level = 1; level <= top; ++level) {
    const cv::Mat& below = levels.back();
    const cv::Size half(below.cols / 2, below.rows / 2);
    if (half.width < kSmallest || half.height < kSmallest) break;
    cv::Mat next;
    cv::resize(below(cv::Rect(0, 0, 2 * half.width, 2 * half.height)), next, half, 0, 0,
               cv::INTER_AREA);
    levels.push_back(next);
  }
  return levels;
}

}  // namespace mbncc
