// SPDX-License-Identifier: BSD-3-Clause
#include "learning/segmentation/intruders.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "learning/change/departure_scores.hpp"
#include "learning/likelihood/background_likelihood.hpp"
#include "learning/segmentation/graph_cut.hpp"
#include "learning/segmentation/smoothness.hpp"

namespace mbncc::segmentation {
namespace {

constexpr double kDepartureScore = 1.5;  // from this score on, something left rather than arrived
constexpr int kFewestPixels = 20;        // least pixels of an entry patch
constexpr float kAnyColour = 0.02F;      // part of an intruder's pixels in colours not seen outside
constexpr float kHighestColourLogOdds = 6;  // largest log-odds from the colour after
constexpr float kPlatformLogOdds = 2;       // largest log-odds from a similarity to the platform
constexpr float kPlatformWeight = 0.5F;
constexpr float kCertain = 30;  // unary of certain pixels

cv::Mat log_density(const change::ColourMixture& mixture, const cv::Mat& image, float any_colour) {
  cv::Mat relative = mixture.densities(image) * std::exp(-likelihood::log_uniform_colour()),
          logarithm;
  cv::log(relative + any_colour, logarithm);
  return logarithm;
}

cv::Mat bounded(const cv::Mat& values, float limit) {
  return cv::max(cv::min(values, limit), -limit);
}

cv::Mat without_departures(const cv::Mat& before, const cv::Mat& after, const cv::Mat& entry,
                           const change::ColourMixture& platform) {
  cv::Mat kept = cv::Mat::zeros(entry.size(), CV_8UC1), labels;
  const int count = cv::connectedComponents(entry, labels, 8, CV_32S);
  const auto scores = change::departure_scores(before, after, labels, count, platform);
  for (int i = 1; i < count; ++i) {
    const cv::Mat patch = labels == i;
    if (scores[i] < kDepartureScore && cv::countNonZero(patch) >= kFewestPixels) kept |= patch;
  }
  return kept;
}

// The connected patches of `map` that contain a pixel of `seeds`.
cv::Mat connected_to(const cv::Mat& seeds, const cv::Mat& map) {
  cv::Mat labels, kept = cv::Mat::zeros(map.size(), CV_8UC1);
  std::vector<bool> wanted(cv::connectedComponents(map, labels, 8, CV_32S), false);
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x)
      if (seeds.at<uchar>(y, x) && map.at<uchar>(y, x)) wanted[labels.at<int>(y, x)] = true;
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x)
      if (wanted[labels.at<int>(y, x)]) kept.at<uchar>(y, x) = 255;
  return kept;
}

}  // namespace

cv::Mat reaching_border(const cv::Mat& changed) {
  cv::Mat joined, frame(changed.size(), CV_8UC1, cv::Scalar(255));
  cv::dilate(changed, joined, cv::Mat());
  frame(cv::Rect(1, 1, changed.cols - 2, changed.rows - 2)).setTo(0);
  return connected_to(frame, joined);
}

cv::Mat find_intruders(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                       const cv::Mat& entry, const change::ColourMixture& platform,
                       const likelihood::NoiseModel& noise) {
  const cv::Mat seeds = without_departures(before, after, entry, platform);
  const change::ColourMixture arrived = change::ColourMixture::fit(after, seeds);
  if (arrived.empty() || platform.empty()) return cv::Mat::zeros(entry.size(), CV_8UC1);
  const cv::Mat platform_after = log_density(platform, after, 1e-4F);
  cv::Mat unary =
      bounded(log_density(arrived, after, kAnyColour) - platform_after, kHighestColourLogOdds) +
      bounded(kPlatformWeight * (log_density(platform, before, 1e-4F) - platform_after),
              kPlatformLogOdds);
  cv::Mat reach;
  cv::dilate(changed, reach, cv::Mat());
  unary.setTo(-kCertain, ~reach);
  unary.setTo(kCertain, seeds);
  return connected_to(seeds, minimum_cut(unary, smoothness(after, before, noise)));
}

}  // namespace mbncc::segmentation
