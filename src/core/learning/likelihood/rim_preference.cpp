// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/rim_preference.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace mbncc::likelihood {
namespace {

constexpr int kReach = 2;              // [px] half the width of the rim
constexpr int kWindow = 15;            // [px] local colours are averaged over this square
constexpr float kFewest = 6;           // least pixels of either side in the square
constexpr float kLeastVariance = 100;  // [grey levels^2] added to the variance of the colours
constexpr float kLeastContrast = 25;   // [variances] least squared distance of both sides' colours
// Largest squared distance of a mixed colour from the line between both sides' colours: parts of
// the squared contrast plus variances.
constexpr float kMixedPart = 0.1F;
constexpr float kMixedNoise = 4;
constexpr float kDarkestLight = 0.3F, kBrightestLight = 2;  // limits of the local light
constexpr float kHighest = 8;                               // largest log-odds

cv::Mat disc(int radius) {
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * radius + 1, 2 * radius + 1});
}

// Sums over the window of the mask's pixels, their colours, and the squared norms of the colours.
struct Side {
  cv::Mat count, colour, square;

  Side(const cv::Mat& image, const cv::Mat& mask) {
    cv::Mat weight, weighted, squares(image.size(), CV_32FC1);
    mask.convertTo(weight, CV_32F, 1 / 255.0);
    cv::Mat channels[] = {weight, weight, weight}, weight3;
    cv::merge(channels, 3, weight3);
    weighted = image.mul(weight3);
    for (int y = 0; y < image.rows; ++y)
      for (int x = 0; x < image.cols; ++x) {
        const auto& w = weighted.at<cv::Vec3f>(y, x);
        squares.at<float>(y, x) = w.dot(w);
      }
    const cv::Size window(kWindow, kWindow);
    cv::boxFilter(weight, count, CV_32F, window, {-1, -1}, false, cv::BORDER_CONSTANT);
    cv::boxFilter(weighted, colour, CV_32F, window, {-1, -1}, false, cv::BORDER_CONSTANT);
    cv::boxFilter(squares, square, CV_32F, window, {-1, -1}, false, cv::BORDER_CONSTANT);
  }

  bool is_sampled(int y, int x) const { return count.at<float>(y, x) >= kFewest; }
  cv::Vec3f mean(int y, int x) const {
    return colour.at<cv::Vec3f>(y, x) / std::max(1.F, count.at<float>(y, x));
  }
  // Variance of a channel, averaged over the channels.
  float variance(int y, int x) const {
    const cv::Vec3f about = mean(y, x);
    return std::max(0.F, square.at<float>(y, x) / count.at<float>(y, x) - about.dot(about)) / 3;
  }
};

// The platform's colour in the local light.
cv::Vec3f lit(const cv::Vec3f& colour, const cv::Vec3f& predicted, const cv::Vec3f& seen) {
  cv::Vec3f result;
  for (int c = 0; c < 3; ++c)
    result[c] =
        colour[c] * std::clamp((seen[c] + 1) / (predicted[c] + 1), kDarkestLight, kBrightestLight);
  return result;
}

}  // namespace

RimPreference rim_preference(const cv::Mat& before, const cv::Mat& platform, const cv::Mat& map,
                             float sigma) {
  cv::Mat inner, outer;
  cv::erode(map, inner, disc(kReach));
  cv::dilate(map, outer, disc(kReach));
  const Side object(before, inner), beside(before, ~outer), predicted(platform, ~outer),
      left(before - platform, ~outer);
  RimPreference rim{cv::Mat::zeros(map.size(), CV_32FC1), cv::Mat::zeros(map.size(), CV_8UC1)};
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) {
      if (inner.at<uchar>(y, x) || !outer.at<uchar>(y, x)) continue;
      if (!object.is_sampled(y, x) || !beside.is_sampled(y, x)) continue;
      const cv::Vec3f here = before.at<cv::Vec3f>(y, x), object_colour = object.mean(y, x),
                      platform_colour = lit(platform.at<cv::Vec3f>(y, x), predicted.mean(y, x),
                                            beside.mean(y, x));
      const float platform_variance = std::min(beside.variance(y, x), left.variance(y, x));
      const float variance =
          (object.variance(y, x) + platform_variance) / 2 + kLeastVariance + sigma * sigma;
      const cv::Vec3f across = object_colour - platform_colour, from_object = here - object_colour,
                      from_platform = here - platform_colour;
      const float contrast = across.dot(across), along = from_platform.dot(across);
      if (contrast < kLeastContrast * variance) continue;
      const float aside = from_platform.dot(from_platform) - along * along / contrast;
      if (aside > kMixedPart * contrast + kMixedNoise * variance) continue;
      const float odds =
          (from_platform.dot(from_platform) - from_object.dot(from_object)) / (2 * variance);
      rim.log_odds.at<float>(y, x) = std::clamp(odds, -kHighest, kHighest);
      rim.valid.at<uchar>(y, x) = 255;
    }
  return rim;
}

}  // namespace mbncc::likelihood
