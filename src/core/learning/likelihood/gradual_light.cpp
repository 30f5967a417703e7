// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/gradual_light.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace mbncc::likelihood {
namespace {

constexpr double kBlur = 1.2;  // [px] standard deviation
constexpr float kDark = 4;     // [grey levels] added to both images, for the ratios of dark pixels
constexpr float kMostLight = 5;  // largest factor between the images
constexpr int kGap = 5;          // [px] narrower gaps in an edge are closed
// Steepest light, and steepest shadow with visible texture, as parts of the main barrier.
constexpr float kFarLower = 0.3F;
constexpr float kLower = 0.5F;
constexpr float kSteepestLight = 10;   // [grey levels / px] steepest light in any case
constexpr float kSteepestShadow = 20;  // [grey levels / px] steepest shadow in any case
constexpr float kNoBrighter = 5;       // [grey levels] that noise may add to a shadow
constexpr float kNoiseSlope = 0.5F;    // [1 / px] slope that noise of standard deviation 1 may have

cv::Mat smooth(const cv::Mat& image) {
  cv::Mat blurred;
  cv::GaussianBlur(image, blurred, {}, kBlur);
  return blurred + cv::Scalar::all(kDark);
}

cv::Mat derivative(const cv::Mat& image, int across, int down) {
  cv::Mat slope;
  cv::Sobel(image, slope, CV_32F, across, down, 3, 1.0 / 8);
  return slope;
}

// Height of the main barrier, which encloses most of the change, weighted by squared differences.
float main_barrier(const cv::Mat& barrier, const cv::Mat& before, const cv::Mat& after,
                   const cv::Mat& changed) {
  std::vector<std::pair<float, float>> weighed;
  float all = 0;
  for (int y = 0; y < barrier.rows; ++y)
    for (int x = 0; x < barrier.cols; ++x) {
      if (changed.at<float>(y, x) <= 0.5F) continue;
      const cv::Vec3f d = before.at<cv::Vec3f>(y, x) - after.at<cv::Vec3f>(y, x);
      weighed.emplace_back(barrier.at<float>(y, x), d.dot(d));
      all += d.dot(d);
    }
  std::sort(weighed.begin(), weighed.end());
  float below = 0;
  for (const auto& [height, weight] : weighed)
    if ((below += weight) >= all / 2) return height;
  return 0;
}

// Pixels where no channel is brighter before than after, beyond noise.
cv::Mat darker(const cv::Mat& before, const cv::Mat& after) {
  cv::Mat dark;
  cv::inRange(before - after, cv::Scalar::all(-1e9), cv::Scalar::all(kNoBrighter), dark);
  return dark;
}

// Slope [grey levels / px] of `before` minus `after`, with `after` in the light of `before`: root
// of the sum of squares over the channels.
cv::Mat light_slope(const cv::Mat& before, const cv::Mat& after) {
  const cv::Mat b = smooth(before), a = smooth(after);
  cv::Mat slope = cv::Mat::zeros(before.size(), CV_32FC1);
  for (const bool down : {false, true}) {
    const cv::Mat db = derivative(b, !down, down), da = derivative(a, !down, down);
    for (int y = 0; y < slope.rows; ++y) {
      const auto *pb = b.ptr<float>(y), *pa = a.ptr<float>(y);
      const auto *pdb = db.ptr<float>(y), *pda = da.ptr<float>(y);
      auto* out = slope.ptr<float>(y);
      for (int x = 0; x < slope.cols; ++x)
        for (int i = 3 * x; i < 3 * x + 3; ++i) {
          const float light = std::clamp(pb[i] / pa[i], 1 / kMostLight, kMostLight);
          const float left = pdb[i] - light * pda[i];
          out[x] += left * left;
        }
    }
  }
  cv::sqrt(slope, slope);
  return slope;
}

}  // namespace

cv::Mat barrier_from_frame(const cv::Mat& heights, const cv::Mat& closed) {
  constexpr int kLevels = 512;
  double highest = 0;
  cv::minMaxLoc(heights, nullptr, &highest);
  const float step = std::max(1e-6F, static_cast<float>(highest) / (kLevels - 1));
  const auto level_of = [step](float height) { return static_cast<int>(height / step); };
  std::vector<std::vector<cv::Point>> open(kLevels);
  cv::Mat level(heights.size(), CV_32SC1, cv::Scalar(-1));
  const auto reach = [&](const cv::Point& at, int from) {
    int& there = level.at<int>(at);
    if (there >= 0) return;
    there = std::max(from, level_of(heights.at<float>(at)));
    open[there].push_back(at);
  };
  const auto enter = [&](const cv::Point& at) {
    if (closed.empty() || !closed.at<uchar>(at)) reach(at, 0);
  };
  for (int x = 0; x < heights.cols; ++x)
    for (const int y : {0, heights.rows - 1}) enter({x, y});
  for (int y = 0; y < heights.rows; ++y)
    for (const int x : {0, heights.cols - 1}) enter({x, y});
  const cv::Rect room({0, 0}, heights.size());
  for (int now = 0; now < kLevels; ++now)
    while (!open[now].empty()) {
      const cv::Point at = open[now].back();
      open[now].pop_back();
      for (const cv::Point& way :
           {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)})
        if (room.contains(at + way)) reach(at + way, now);
    }
  level.setTo(kLevels, level < 0);
  cv::Mat barrier;
  level.convertTo(barrier, CV_32F, step);
  return barrier;
}

cv::Mat gradual_light(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                      const cv::Mat& texture_loss, float sigma) {
  const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, {kGap, kGap});
  const cv::Mat slope = light_slope(before, after);
  cv::Mat closed;
  cv::dilate(slope, closed, disc);
  const cv::Mat barrier = barrier_from_frame(closed, changed > 0.5);
  const float main = main_barrier(barrier, before, after, changed);
  const auto reached = [&](float limit) -> cv::Mat {
    if (limit < kNoiseSlope * sigma) return cv::Mat::zeros(before.size(), CV_8UC1);
    cv::Mat light = barrier < limit;
    cv::dilate(light, light, disc);
    return light & (slope < limit);
  };
  return reached(std::min(kSteepestLight, kFarLower * main)) |
         (reached(std::min(kSteepestShadow, kLower * main)) & darker(before, after) &
          (texture_loss < 0));
}

}  // namespace mbncc::likelihood
