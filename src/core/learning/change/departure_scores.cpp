// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/departure_scores.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace mbncc::change {
namespace {

constexpr float kLogCap = 4;      // largest log-evidence of one pixel
constexpr float kEdgeWeight = 4;  // weight of the border's evidence
constexpr float kEdgeFloor = 8;   // [grey levels] weaker edges have little weight

// Strength of grey edges: each pixel takes the strongest within one pixel.
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
  double platform = 0, pixels = 0;         // sum of the colours' evidence
  double edge_before = 0, edge_after = 0;  // sums along the border
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

}  // namespace mbncc::change
