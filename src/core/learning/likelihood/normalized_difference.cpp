// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/normalized_difference.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mbncc::likelihood {
namespace {

// A neighbour's distance counts at most kFarNeighbour plus kFarFactor times the pixel's own
// distance.
constexpr float kFarNeighbour = 6;
constexpr float kFarFactor = 2;

}  // namespace

cv::Mat normalized_difference(const cv::Mat& before, const cv::Mat& predicted,
                              const cv::Mat& variance, const cv::Matx33f& correlation) {
  cv::Mat result(before.size(), CV_32FC1);
  const cv::Matx33f p = correlation.inv(cv::DECOMP_CHOLESKY);
  for (int y = 0; y < before.rows; ++y) {
    const auto* b = before.ptr<float>(y);
    const auto* q = predicted.ptr<float>(y);
    const auto* v = variance.ptr<float>(y);
    auto* out = result.ptr<float>(y);
    for (int x = 0; x < before.cols; ++x) {
      const int i = 3 * x;
      const float d0 = (b[i] - q[i]) / std::sqrt(v[i]),
                  d1 = (b[i + 1] - q[i + 1]) / std::sqrt(v[i + 1]),
                  d2 = (b[i + 2] - q[i + 2]) / std::sqrt(v[i + 2]);
      out[x] = d0 * d0 * p(0, 0) + d1 * d1 * p(1, 1) + d2 * d2 * p(2, 2) +
               2 * (d0 * d1 * p(0, 1) + d0 * d2 * p(0, 2) + d1 * d2 * p(1, 2));
    }
  }
  return result;
}

void pool(cv::Mat& values) {
  cv::Mat framed;
  cv::copyMakeBorder(values, framed, 1, 1, 1, 1, cv::BORDER_REFLECT_101);
  std::vector<float> most(values.cols), sum(values.cols);
  for (int y = 0; y < values.rows; ++y) {
    auto* own = values.ptr<float>(y);
    for (int x = 0; x < values.cols; ++x) most[x] = kFarNeighbour + kFarFactor * own[x];
    std::fill(sum.begin(), sum.end(), 0.F);
    for (int dy = 0; dy < 3; ++dy)
      for (int dx = 0; dx < 3; ++dx) {
        const auto* neighbour = framed.ptr<float>(y + dy) + dx;
        for (int x = 0; x < values.cols; ++x) sum[x] += std::min(neighbour[x], most[x]);
      }
    for (int x = 0; x < values.cols; ++x)
      own[x] = (1 - kPooledPart) * own[x] + kPooledPart / 9 * sum[x];
  }
}

}  // namespace mbncc::likelihood
