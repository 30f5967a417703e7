// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/arrivals.hpp"

#include <algorithm>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "learning/change/departure_scores.hpp"

namespace mbncc::change {
namespace {

constexpr double kArrivalScore = -1.5;  // departure score below which a patch may be an arrival
constexpr double kClearance = 2;    // an arrival scores lower than the best patch by at least this
constexpr int kSeam = 7;            // [px] patches less far apart are joined
constexpr int kSmallestPatch = 20;  // [px] least area of an arrival

std::vector<int> areas_of(const cv::Mat& labels, int count) {
  std::vector<int> areas(count, 0);
  for (const int label : cv::Mat_<int>(labels))
    if (label != 0) ++areas[label];
  return areas;
}

// Patches less than kSeam apart are joined, because an edge of the platform may split them. The
// result is 0 outside `changed`.
int patches_of(const cv::Mat& changed, cv::Mat& labels) {
  cv::Mat joined;
  cv::morphologyEx(changed, joined, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {kSeam, kSeam}));
  const int count = cv::connectedComponents(joined, labels, 8, CV_32S);
  labels.setTo(0, ~changed);
  return count;
}

}  // namespace

cv::Mat find_arrivals(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                      const ColourMixture& platform) {
  cv::Mat arrivals = cv::Mat::zeros(changed.size(), CV_8UC1);
  cv::Mat labels;
  const int count = patches_of(changed, labels);
  if (platform.empty() || count <= 2) return arrivals;
  const auto scores = departure_scores(before, after, labels, count, platform);
  const auto areas = areas_of(labels, count);
  const int largest = *std::max_element(areas.begin(), areas.end());
  double best = -std::numeric_limits<double>::infinity();
  for (int i = 1; i < count; ++i)
    if (areas[i] > largest / 10) best = std::max(best, scores[i]);
  for (int i = 1; i < count; ++i)
    if (areas[i] >= kSmallestPatch && scores[i] < kArrivalScore && best > scores[i] + kClearance)
      arrivals.setTo(255, labels == i);
  return arrivals;
}

}  // namespace mbncc::change
