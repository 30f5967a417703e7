// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/arrival_test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "learning/change/survey_size.hpp"

namespace mbncc::change {
namespace {

constexpr float kLogCap = 4;                // of one pixel's evidence
constexpr float kEdgeWeight = 4;            // of the border's evidence
constexpr float kEdgeFloor = 8;             // [grey levels] weaker edges have little weight
constexpr double kArrivalScore = -1.5;      // an arrival scores less
constexpr double kClearance = 2;            // and is lower than the best patch by this much
constexpr double kLoneArrivalScore = -0.5;  // the same, without another patch to compare with
constexpr int kSeam = 7;                    // [px]
constexpr int kSmallestPatch = 20;          // [px]

cv::Mat surveyed(const cv::Mat& image) {
  cv::Mat values;
  survey_sized(image).convertTo(values, CV_32F);
  return values;
}

// `after` with the exposure of `before`, from their means over the unchanged pixels.
cv::Mat exposed_as(const cv::Mat& before, const cv::Mat& after, const cv::Mat& unchanged) {
  const cv::Scalar wanted = cv::mean(before, unchanged), given = cv::mean(after, unchanged);
  cv::Mat channels[3], result;
  cv::split(after, channels);
  for (int c = 0; c < 3; ++c) channels[c] *= wanted[c] / std::max(1.0, given[c]);
  cv::merge(channels, 3, result);
  return result;
}

// Grey edges, the strongest within a pixel.
cv::Mat edge_strength(const cv::Mat& image) {
  cv::Mat grey, gx, gy, strength;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  const cv::Mat central = (cv::Mat_<float>(1, 3) << -1, 0, 1);
  cv::filter2D(grey, gx, CV_32F, central);
  cv::filter2D(grey, gy, CV_32F, central.t());
  cv::dilate(cv::abs(gx) + cv::abs(gy), strength, cv::Mat());
  return strength;
}

bool on_border(const cv::Mat& labels, int y, int x) {
  const int label = labels.at<int>(y, x);
  return labels.at<int>(y, std::max(x - 1, 0)) != label ||
         labels.at<int>(y, std::min(x + 1, labels.cols - 1)) != label ||
         labels.at<int>(std::max(y - 1, 0), x) != label ||
         labels.at<int>(std::min(y + 1, labels.rows - 1), x) != label;
}

struct PatchSums {
  double platform = 0, pixels = 0;         // evidence of the colours
  double edge_before = 0, edge_after = 0;  // along the border
  double border = 0;                       // [px]

  double score() const {
    const double before = edge_before / std::max(1.0, border);
    const double after = edge_after / std::max(1.0, border);
    return platform / std::max(1.0, pixels) +
           kEdgeWeight * (before - after) / (before + after + kEdgeFloor);
  }
};

float log_density(const ColourMixture& mixture, const cv::Vec3f& colour) {
  return std::log(mixture.density(colour) + 1e-11F);
}

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

std::vector<double> departure_scores(const cv::Mat& before, const cv::Mat& after,
                                     const cv::Mat& labels, int count,
                                     const ColourMixture& platform) {
  const cv::Mat edge_before = edge_strength(before), edge_after = edge_strength(after);
  std::vector<PatchSums> sums(count);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) {
      const int label = labels.at<int>(y, x);
      if (label == 0) continue;
      PatchSums& patch = sums[label];
      const float evidence = log_density(platform, after.at<cv::Vec3f>(y, x)) -
                             log_density(platform, before.at<cv::Vec3f>(y, x));
      patch.platform += std::clamp(evidence, -kLogCap, kLogCap);
      patch.pixels += 1;
      if (!on_border(labels, y, x)) continue;
      patch.edge_before += edge_before.at<float>(y, x);
      patch.edge_after += edge_after.at<float>(y, x);
      patch.border += 1;
    }
  std::vector<double> scores;
  for (const auto& patch : sums) scores.push_back(patch.score());
  return scores;
}

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

cv::Mat departures(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed) {
  const cv::Mat b = surveyed(before), a = surveyed(after);
  cv::Mat patches, near, labels, left = cv::Mat::zeros(b.size(), CV_32FC1), result;
  cv::resize(changed, patches, b.size(), 0, 0, cv::INTER_NEAREST);
  cv::dilate(patches, near, cv::Mat(), {-1, -1}, 3);
  const cv::Mat unchanged = near == 0;
  const ColourMixture platform = ColourMixture::fit(b, unchanged);
  if (platform.empty()) return cv::Mat_<float>(changed / 255);
  const int count = cv::connectedComponents(patches, labels, 8, CV_32S);
  const auto scores = departure_scores(b, exposed_as(b, a, unchanged), labels, count, platform);
  for (int i = 1; i < count; ++i)
    left.setTo(std::max(0.0, scores[i] - kLoneArrivalScore), labels == i);
  cv::resize(left, result, changed.size(), 0, 0, cv::INTER_NEAREST);
  return result;
}

}  // namespace mbncc::change
