// SPDX-License-Identifier: BSD-3-Clause
#include "cell/capture/motion.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "numeric/order_statistics.hpp"

namespace mbncc::capture {
namespace {

constexpr int kWidth = 160;             // [px] width of a motion image
constexpr int kSampledWidth = 640;      // [px] wider images are subsampled first
constexpr double kLeastDifference = 5;  // [grey levels] least threshold of motion
constexpr double kSureDifference = 30;  // [grey levels] largest threshold of motion
constexpr double kNoiseFactor = 6;      // threshold in standard deviations of the pair's noise
constexpr int kLeastPatch = 3;          // [px] moved pixels of a motion image, after opening

float median_of(const cv::Mat& values) {
  std::vector<float> all = values.reshape(1, 1);
  return numeric::median(all);
}

}  // namespace

cv::Mat motion_image(const cv::Mat& image) {
  // Area averages of a large image are slow, and a quarter of its pixels suffices.
  cv::Mat sampled = image, small, grey, values;
  if (image.cols > kSampledWidth) {
    const double share = static_cast<double>(kSampledWidth) / image.cols;
    cv::resize(image, sampled, {}, share, share, cv::INTER_NEAREST);
  }
  const double scale = std::min(1.0, static_cast<double>(kWidth) / image.cols);
  const cv::Size size(std::max(1, cvRound(scale * image.cols)),
                      std::max(1, cvRound(scale * image.rows)));
  cv::resize(sampled, small, size, 0, 0, cv::INTER_AREA);
  cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
  grey.convertTo(values, CV_32F);
  return values;
}

bool has_moved(const cv::Mat& a, const cv::Mat& b) {
  const cv::Mat ratio = (b + 8) / (a + 8);
  const float gain = median_of(ratio);
  const cv::Mat difference = cv::abs(b + 8 - gain * (a + 8));
  const double noise = numeric::deviation_of_mad(median_of(difference));
  cv::Mat moved = difference > std::clamp(kNoiseFactor * noise, kLeastDifference, kSureDifference);
  cv::morphologyEx(moved, moved, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, {2, 2}));
  return cv::countNonZero(moved) >= kLeastPatch;
}

}  // namespace mbncc::capture
