// SPDX-License-Identifier: BSD-3-Clause
#include "learning/scribbles.hpp"

#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc.hpp>

namespace mbncc::bench {
namespace {

constexpr int kClearance = 6;    // [px] from the outline to the stroke around the object
constexpr int kStrokeWidth = 3;  // [px]

cv::Mat grown(const cv::Mat& map, int pixels) {
  cv::Mat result;
  const cv::Size size(2 * pixels + 1, 2 * pixels + 1);
  cv::dilate(map, result, cv::getStructuringElement(cv::MORPH_ELLIPSE, size));
  return result;
}

/// The middle lines, plus the core, because the lines of a disc or square shrink to a point.
cv::Mat strokes_on(const cv::Mat& map) {
  cv::Mat line, distance;
  cv::ximgproc::thinning(map, line);
  cv::distanceTransform(map, distance, cv::DIST_L2, 5);
  double widest = 0;
  cv::minMaxLoc(distance, nullptr, &widest);
  return (grown(line, kStrokeWidth / 2) | (distance > widest / 2)) & map;
}

}  // namespace

cv::Mat scribbled(const cv::Mat& true_map, const cv::Rect& region) {
  cv::Mat labels(true_map.size(), CV_8UC1, cv::Scalar(cv::GC_BGD));
  labels(region).setTo(cv::GC_PR_FGD);
  labels.setTo(cv::GC_BGD,
               grown(true_map, kClearance + kStrokeWidth) & ~grown(true_map, kClearance));
  labels.setTo(cv::GC_FGD, strokes_on(true_map));
  return labels;
}

}  // namespace mbncc::bench
