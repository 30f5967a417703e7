// SPDX-License-Identifier: BSD-3-Clause
#include "imaging/filled_outline.hpp"

#include <opencv2/imgproc.hpp>

namespace mbncc::imaging {

cv::Mat filled(const std::vector<cv::Point2f>& outline, const cv::Rect& box) {
  std::vector<cv::Point> corners;
  for (const auto& point : outline)
    corners.emplace_back(cvRound(point.x) - box.x, cvRound(point.y) - box.y);
  cv::Mat area = cv::Mat::zeros(box.size(), CV_8UC1);
  cv::fillPoly(area, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(255));
  return area;
}

}  // namespace mbncc::imaging
