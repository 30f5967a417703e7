// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/cast_shadow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

namespace mbncc::likelihood {
namespace {

constexpr float kDark = 4;  // [grey levels] added to both images before the quotient
constexpr float kFaintest = -0.12F, kDarkest = -1.5F;  // limits of the log of a shadow's light
constexpr float kTint = 0.2F;          // largest difference of the log light between channels
constexpr float kBin = 0.04F;          // of the histogram of the log light
constexpr float kDeviation = 0.12F;    // of the log light from that of the shadow
constexpr int kFewestPixels = 30;      // of a connected shadow
constexpr int kShadows = 3;            // of different light
constexpr double kFine = 2;            // [px] texture is the deviation from a mean of this sigma
constexpr double kLeastEvidence = 80;  // likelihood ratio, 2 log

// Logarithm of the light that is left, CV_32FC1; 0 where the channels differ too much.
cv::Mat log_light(const cv::Mat& before, const cv::Mat& after) {
  cv::Mat seen, lit, light(before.size(), CV_32FC1);
  cv::blur(before, seen, {3, 3});
  cv::blur(after, lit, {3, 3});
  for (int y = 0; y < light.rows; ++y)
    for (int x = 0; x < light.cols; ++x) {
      std::array<float, 3> logs;
      for (int c = 0; c < 3; ++c)
        logs[c] =
            std::log((seen.at<cv::Vec3f>(y, x)[c] + kDark) / (lit.at<cv::Vec3f>(y, x)[c] + kDark));
      const auto [low, high] = std::minmax_element(logs.begin(), logs.end());
      light.at<float>(y, x) = *high - *low < kTint ? (logs[0] + logs[1] + logs[2]) / 3 : 0;
    }
  return light;
}

// The most frequent log light of a shadow within `candidates`.
float most_frequent(const cv::Mat& light, const cv::Mat& candidates) {
  std::array<int, 40> counts{};
  for (int y = 0; y < light.rows; ++y)
    for (int x = 0; x < light.cols; ++x)
      if (candidates.at<uchar>(y, x) != 0)
        ++counts[static_cast<std::size_t>(-light.at<float>(y, x) / kBin)];
  std::size_t best = 2;
  int most = -1;
  for (std::size_t i = 2; i + 2 < counts.size(); ++i) {
    const int sum = std::accumulate(&counts[i - 2], &counts[i + 3], 0);
    if (sum > most) {
      most = sum;
      best = i;
    }
  }
  return -kBin * (static_cast<float>(best) + 0.5F);
}

cv::Mat grey(const cv::Mat& image) {
  cv::Mat sum;
  cv::transform(image, sum, cv::Matx13f(1, 1, 1));
  return sum;
}

// Deviation from the local mean over `part` (CV_32FC1, 0 or 1); 0 outside.
cv::Mat texture(const cv::Mat& image, const cv::Mat& part) {
  cv::Mat mean, weight;
  cv::GaussianBlur(image.mul(part), mean, {}, kFine);
  cv::GaussianBlur(part, weight, {}, kFine);
  return (image - mean / cv::max(weight, 1e-3F)).mul(part);
}

// Compares the texture before with that after in this light, and with none of it.
bool has_same_texture(const cv::Mat& before, const cv::Mat& after, float light,
                      const cv::Mat& part) {
  cv::Mat weight;
  part.convertTo(weight, CV_32FC1, 1 / 255.);
  const cv::Mat seen = texture(grey(before), weight), lit = texture(grey(after), weight);
  const cv::Mat left = seen - light * lit;
  const double unexplained = (left.dot(left) + 1) / (seen.dot(seen) + 1);
  return -cv::countNonZero(part) * std::log(unexplained) > kLeastEvidence;
}

cv::Mat parts_with_same_texture(const cv::Mat& before, const cv::Mat& after, float light,
                                const cv::Mat& even) {
  cv::Mat solid, labels, stats, centres, same = cv::Mat::zeros(even.size(), CV_8UC1);
  cv::morphologyEx(even, solid, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8U));
  const int count = cv::connectedComponentsWithStats(solid, labels, stats, centres);
  for (int i = 1; i < count; ++i) {
    if (stats.at<int>(i, cv::CC_STAT_AREA) < kFewestPixels) continue;
    const cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                       stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
    const cv::Mat part = labels(box) == i;
    if (has_same_texture(before(box), after(box), light, part)) same(box).setTo(255, part);
  }
  return same;
}

}  // namespace

cv::Mat cast_shadow(const cv::Mat& before, const cv::Mat& after) {
  const cv::Mat light = log_light(before, after);
  cv::Mat candidates = (light < kFaintest) & (light > kDarkest);
  cv::Mat shadow = cv::Mat::zeros(before.size(), CV_8UC1);
  for (int i = 0; i < kShadows && cv::countNonZero(candidates) >= kFewestPixels; ++i) {
    const float most = most_frequent(light, candidates);
    const cv::Mat even = candidates & (light > most - kDeviation) & (light < most + kDeviation);
    shadow |= parts_with_same_texture(before, after, std::exp(most), even);
    candidates.setTo(0, even);
  }
  return shadow;
}

}  // namespace mbncc::likelihood
