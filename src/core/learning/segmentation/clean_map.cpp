// SPDX-License-Identifier: BSD-3-Clause
#include "learning/segmentation/clean_map.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <set>
#include <vector>

namespace mbncc::segmentation {
namespace {

constexpr double kKeptWeight = 0.18;   // least weight of a kept group, relative to the heaviest
constexpr int kSmallestHole = 12;      // [px] holes up to this area are always filled
constexpr double kFilledPart = 0.002;  // largest filled hole, as a part of the map

cv::Mat group_labels(const cv::Mat& map, int gap, int& count) {
  const cv::Mat disc =
      cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * gap + 1, 2 * gap + 1));
  cv::Mat grown, labels;
  cv::dilate(map, grown, disc);
  count = cv::connectedComponents(grown, labels, 8, CV_32S);
  return labels;
}

std::vector<double> group_weights(const cv::Mat& map, const cv::Mat& labels, int count,
                                  const cv::Mat& weight) {
  constexpr double kPresence = 0.01;  // a group without any positive weight still counts a little
  std::vector<double> weights(count, 0);
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) {
      if (!map.at<uchar>(y, x)) continue;
      const double pixel = weight.empty() ? 1 : std::max(0.F, weight.at<float>(y, x)) + kPresence;
      weights[labels.at<int>(y, x)] += pixel;
    }
  return weights;
}

std::set<int> labels_under(const cv::Mat& mask, const cv::Mat& labels) {
  std::set<int> result;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x)
      if (mask.at<uchar>(y, x)) result.insert(labels.at<int>(y, x));
  return result;
}

}  // namespace

void keep_main_groups(cv::Mat& map, const cv::Mat& weight, const cv::Mat& wanted, int gap) {
  int count = 0;
  const cv::Mat labels = group_labels(map, gap, count);
  if (count <= 2) return;
  auto weights = group_weights(map, labels, count, weight);
  const double least = kKeptWeight * *std::max_element(weights.begin(), weights.end());
  for (const int label : labels_under(wanted, labels))
    weights[label] = std::max(weights[label], least);
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x)
      if (weights[labels.at<int>(y, x)] < least) map.at<uchar>(y, x) = 0;
}

void remove_specks(cv::Mat& map, int area) {
  cv::Mat labels, stats, centres;
  cv::connectedComponentsWithStats(map, labels, stats, centres, 8, CV_32S);
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x)
      if (stats.at<int>(labels.at<int>(y, x), cv::CC_STAT_AREA) < area) map.at<uchar>(y, x) = 0;
}

void fill_holes(cv::Mat& map, int area) {
  cv::Mat background, labels, stats, centres;
  cv::copyMakeBorder(255 - map, background, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(255));
  cv::connectedComponentsWithStats(background, labels, stats, centres, 4, CV_32S);
  const int outside = labels.at<int>(0, 0);
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) {
      const int label = labels.at<int>(y + 1, x + 1);
      if (label != outside && stats.at<int>(label, cv::CC_STAT_AREA) <= area)
        map.at<uchar>(y, x) = 255;
    }
}

cv::Mat clean_map(const cv::Mat& raw, const cv::Mat& weight, const cv::Mat& wanted) {
  cv::Mat map = raw.clone();
  keep_main_groups(map, weight, wanted);
  fill_holes(map, std::max(kSmallestHole, static_cast<int>(kFilledPart * cv::countNonZero(map))));
  cv::Mat smooth;
  cv::medianBlur(map, smooth, 3);
  return smooth;
}

}  // namespace mbncc::segmentation
