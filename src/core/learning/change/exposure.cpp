// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/exposure.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "numeric/order_statistics.hpp"

namespace mbncc::change {
namespace {

constexpr int kSampling = 2;  // [px] sampling step

using Ratios = std::array<std::vector<float>, 3>;  // ratios of brightness, per channel

// Dark and saturated pixels are ignored.
Ratios brightness_ratios(const cv::Mat& before, const cv::Mat& after) {
  Ratios ratios;
  for (int y = 0; y < before.rows; y += kSampling) {
    const auto* b = before.ptr<cv::Vec3b>(y);
    const auto* a = after.ptr<cv::Vec3b>(y);
    for (int x = 0; x < before.cols; x += kSampling)
      for (int c = 0; c < 3; ++c)
        if (a[x][c] > 10 && a[x][c] < 245 && b[x][c] < 245)
          ratios[c].push_back(static_cast<float>(b[x][c]) / a[x][c]);
  }
  return ratios;
}

cv::Vec3f exposure_ratio(Ratios& ratios) {
  constexpr std::size_t kFewest = 100;
  cv::Vec3f gain(1, 1, 1);
  for (int c = 0; c < 3; ++c)
    if (ratios[c].size() > kFewest) gain[c] = numeric::median(ratios[c]);
  return gain;
}

double mean_of(const cv::Vec3f& values) {
  return (values[0] + values[1] + values[2]) / 3;
}

}  // namespace

Exposure exposure_of(const cv::Mat& before, const cv::Mat& after) {
  const cv::Size half(before.cols / 2, before.rows / 2);
  double low = 1e9, high = 0;
  Ratios all;
  for (const int x : {0, before.cols - half.width})
    for (const int y : {0, before.rows - half.height}) {
      const cv::Rect quarter({x, y}, half);
      Ratios ratios = brightness_ratios(before(quarter), after(quarter));
      for (int c = 0; c < 3; ++c) all[c].insert(all[c].end(), ratios[c].begin(), ratios[c].end());
      const double gain = mean_of(exposure_ratio(ratios));
      low = std::min(low, gain);
      high = std::max(high, gain);
    }
  Exposure exposure;
  exposure.gain = exposure_ratio(all);
  exposure.mean = mean_of(exposure.gain);
  exposure.unevenness = high / std::max(low, 1e-3);
  return exposure;
}

}  // namespace mbncc::change
