// SPDX-License-Identifier: BSD-3-Clause
#include "learning/map_score.hpp"

#include <opencv2/imgproc.hpp>

namespace mbncc::bench {
namespace {

constexpr double kRounding = 1e-3;  // error of the distance transform

cv::Mat boundary(const cv::Mat& map) {
  cv::Mat inner;
  cv::erode(map, inner, cv::Mat::ones(3, 3, CV_8U), {-1, -1}, 1, cv::BORDER_CONSTANT, 0);
  return map & ~inner;
}

/// Fraction of `boundary` that lies within the tolerance of `other`.
double part_near(const cv::Mat& boundary, const cv::Mat& other, double tolerance) {
  cv::Mat distance;
  cv::distanceTransform(~other, distance, cv::DIST_L2, 5);
  const cv::Mat near = (distance <= tolerance + kRounding) & boundary;
  return static_cast<double>(cv::countNonZero(near)) / cv::countNonZero(boundary);
}

double boundary_f(const cv::Mat& map, const cv::Mat& standard, double tolerance) {
  const cv::Mat a = boundary(map), b = boundary(standard);
  if (cv::countNonZero(a) == 0 || cv::countNonZero(b) == 0) return 0;
  const double precision = part_near(a, b, tolerance), recall = part_near(b, a, tolerance);
  return precision + recall > 0 ? 2 * precision * recall / (precision + recall) : 0;
}

}  // namespace

MapScore score_map(const cv::Mat& map, const cv::Mat& standard, double boundary_tolerance) {
  MapScore score;
  if (cv::countNonZero(map) == 0) return score;
  const double common = cv::countNonZero(map & standard);
  score.iou = common / cv::countNonZero(map | standard);
  score.boundary_f = boundary_f(map, standard, boundary_tolerance);
  score.accuracy =
      1 - static_cast<double>(cv::countNonZero(map ^ standard)) / cv::countNonZero(standard);
  return score;
}

}  // namespace mbncc::bench
