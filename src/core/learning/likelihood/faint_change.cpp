// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/faint_change.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace mbncc::likelihood {
namespace {

constexpr float kFreedom = 3;       // channels; the mean squared distance of explained pixels
constexpr float kModelError = .06;  // error of the shadow model, relative to the brightness
constexpr float kHighest = 9;       // a pixel's squared distance counts at most this
constexpr int kWindow = 7;          // [px]
constexpr float kSignificant = 5;   // [standard deviations] significant mean of a window
constexpr float kNear = 4;          // least mean squared distance of a pixel and its neighbours
constexpr int kWideWindow = 9;      // [px] gaps and rims are narrower
constexpr float kWidePart = 0.5;    // least changed part of the wide window
constexpr int kWideGrown = 5;       // [px]
constexpr float kDark = 0.33F;      // least mean part of noise in the expected difference

// Factor on squared distances that accounts for the model's error in addition to noise.
cv::Mat noise_part(const cv::Mat& after, const cv::Mat& variance, float tail) {
  cv::Mat part(after.size(), CV_32FC1);
  for (int y = 0; y < after.rows; ++y) {
    const auto* a = after.ptr<cv::Vec3f>(y);
    const auto* v = variance.ptr<cv::Vec3f>(y);
    auto* out = part.ptr<float>(y);
    for (int x = 0; x < after.cols; ++x) {
      const float noise = v[x][0] + v[x][1] + v[x][2];
      out[x] = noise / (noise + kModelError * kModelError * a[x].dot(a[x])) / tail;
    }
  }
  return part;
}

cv::Mat box_mean(const cv::Mat& values, int side) {
  cv::Mat mean;
  cv::boxFilter(values, mean, CV_32F, {side, side});
  return mean;
}

// Where the distances exceed those of noise.
cv::Mat unexplained(const cv::Mat& distance, const cv::Mat& part) {
  static const float least = kFreedom + kSignificant * std::sqrt(2 * kFreedom) / kWindow;
  const cv::Mat bounded = cv::min(distance.mul(part), kHighest);
  return (box_mean(bounded, kWindow) > least) & (box_mean(bounded, 3) > kNear);
}

}  // namespace

cv::Mat faint_change(const Misfit& misfit, const cv::Mat& after, const cv::Mat& variance,
                     float tail, const cv::Mat& sure) {
  const cv::Mat part = noise_part(after, variance, tail);
  if (cv::mean(part)[0] * tail < kDark) return cv::Mat::zeros(after.size(), CV_8UC1);
  const cv::Mat faint = unexplained(misfit.unchanged, part) & unexplained(misfit.shaded, part);
  cv::Mat wide = box_mean(faint & ~sure, kWideWindow) > 255 * kWidePart;
  cv::dilate(wide, wide, cv::Mat::ones(kWideGrown, kWideGrown, CV_8U));
  return faint & wide;
}

}  // namespace mbncc::likelihood
