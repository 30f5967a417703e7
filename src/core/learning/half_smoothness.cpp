#include "learning/half_smoothness.hpp"

#include <utility>

namespace mbncc {
namespace {

cv::Size half_size(const cv::Size& size) {
  return {(size.width + 1) / 2, (size.height + 1) / 2};
}

// Adds to the edge between two neighbouring blocks, which the one later in row-major order owns.
void add_weight(cv::Point a, cv::Point b, float weight, Smoothness& half) {
  if (a.y < b.y || (a.y == b.y && a.x < b.x)) std::swap(a, b);
  for (std::size_t k = 0; k < half.weights.size(); ++k)
    if (b == a + cv::Point(Smoothness::kDx[k], Smoothness::kDy[k]))
      half.weights[k].at<float>(a) += weight;
}

}  // namespace

cv::Mat half_resolution(const cv::Mat& unary) {
  cv::Mat half = cv::Mat::zeros(half_size(unary.size()), CV_32FC1);
  for (int y = 0; y < unary.rows; ++y)
    for (int x = 0; x < unary.cols; ++x) half.at<float>(y / 2, x / 2) += unary.at<float>(y, x);
  return half;
}

Smoothness half_resolution(const Smoothness& smoothness) {
  const cv::Size size = smoothness.weights[0].size();
  Smoothness half;
  half.strength = 2 * smoothness.strength;
  for (auto& weights : half.weights) weights = cv::Mat::zeros(half_size(size), CV_32FC1);
  for (std::size_t k = 0; k < smoothness.weights.size(); ++k)
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const float weight = smoothness.weights[k].at<float>(y, x);
        if (weight <= 0) continue;
        const cv::Point own(x / 2, y / 2);
        const cv::Point other((x + Smoothness::kDx[k]) / 2, (y + Smoothness::kDy[k]) / 2);
        if (other != own) add_weight(own, other, weight, half);
      }
  return half;
}

}  // namespace mbncc
