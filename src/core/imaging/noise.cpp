// SPDX-License-Identifier: BSD-3-Clause
#include "imaging/noise.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace mbncc::imaging {
namespace {

constexpr double kLeast = 2.5;  // [grey levels] compressed images have less and are kept
constexpr double kEdge = 3;     // deviations of the noise: larger differences are edges
constexpr double kReach = 1;    // [px] deviation of the smoothing
constexpr int kSquare = 5;      // [px] its side

const cv::Matx33f kFinest(1, -2, 1, -2, 4, -2, 1, -2, 1);

/// Of the absolute values of CV_16SC1 `values` below 16 * 256, where `mask` is set or empty.
int median_size(const cv::Mat& values, const cv::Mat& mask) {
  std::array<int, 16 * 256> counts{};
  int all = 0;
  for (int y = 0; y < values.rows; ++y) {
    const auto* row = values.ptr<short>(y);
    for (int x = 0; x < values.cols; ++x) {
      if (!mask.empty() && mask.at<uchar>(y, x) == 0) continue;
      ++counts[std::abs(row[x])];
      ++all;
    }
  }
  int median = 0;
  for (int seen = counts[0]; seen < (all + 1) / 2; seen += counts[++median]) {
  }
  return median;
}

}  // namespace

double noise_deviation(const cv::Mat& image, const cv::Mat& mask) {
  constexpr double kNormalMedian = 0.6745;  // of a normal distribution's absolute values
  std::vector<cv::Mat> channels;
  cv::split(image, channels);
  int most = 0;
  cv::Mat finest;
  for (const cv::Mat& channel : channels) {
    cv::filter2D(channel, finest, CV_16S, kFinest);
    most = std::max(most, median_size(finest, mask));
  }
  return most / (kNormalMedian * cv::norm(kFinest));
}

cv::Mat without_noise(const cv::Mat& image, double deviation) {
  if (deviation < kLeast) return image;
  cv::Mat smooth;
  cv::bilateralFilter(image, smooth, kSquare, kEdge * deviation, kReach);
  return smooth;
}

}  // namespace mbncc::imaging
