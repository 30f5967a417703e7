// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/stage_images.hpp"

#include <opencv2/imgproc.hpp>
#include <vector>

namespace mbncc::teaching {
namespace {

const cv::Scalar kTint(0, 0, 255);     // bgr
const cv::Scalar kFrame(0, 255, 255);  // bgr
const cv::Scalar kOutline(0, 255, 0);  // bgr

}  // namespace

cv::Mat tinted(const cv::Mat& image, const cv::Mat& mask, const cv::Rect& region) {
  cv::Mat painted = image.clone(), mixed;
  painted.setTo(kTint, mask);
  cv::addWeighted(image, 0.5, painted, 0.5, 0, mixed);
  cv::rectangle(mixed, region, kFrame, 2);
  return mixed;
}

cv::Mat outlined(const cv::Mat& image, const cv::Mat& map) {
  cv::Mat drawn = image.clone();
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(map.clone(), contours, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  cv::drawContours(drawn, contours, -1, kOutline, 1);
  return drawn;
}

}  // namespace mbncc::teaching
