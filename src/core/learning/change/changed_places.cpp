// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/changed_places.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "imaging/rectangles.hpp"

namespace mbncc::change {
namespace {

constexpr double kMargin = 0.15;      // margin as a part of a region's longer side
constexpr double kNoisyMargin = 0.6;  // margin where noise hides part of the change
constexpr int kGap = 9;               // [px] pieces nearer than this are joined

struct Patch {
  cv::Rect box;
  int area = 0;       // [px]
  double weight = 0;  // sum of its pixels' weights
};

// Groups of changed pixels, with nearby pieces joined. `labels` contains each group's index in the
// result plus one.
std::vector<Patch> joined_patches(const cv::Mat& changed, cv::Mat& labels) {
  cv::Mat joined, stats, centres;
  cv::morphologyEx(changed, joined, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {kGap, kGap}));
  const int count = cv::connectedComponentsWithStats(joined, labels, stats, centres, 8, CV_32S);
  std::vector<Patch> patches;
  for (int i = 1; i < count; ++i)
    patches.push_back({imaging::box_of_component(stats, i), stats.at<int>(i, cv::CC_STAT_AREA)});
  return patches;
}

cv::Rect with_margin(const cv::Rect& box, bool noisy) {
  const double part = noisy ? kNoisyMargin : kMargin;
  return imaging::grown(box, std::max(8, static_cast<int>(part * std::max(box.width, box.height))));
}

}  // namespace

cv::Rect changed_region(const ChangeSurvey& survey, const cv::Rect& within, double least_part) {
  cv::Mat labels;
  const std::vector<Patch> patches = joined_patches(survey.changed(within), labels);
  int largest = 0;
  for (const Patch& patch : patches) largest = std::max(largest, patch.area);
  cv::Rect box;
  for (const Patch& patch : patches)
    if (patch.area >= least_part * largest) box |= patch.box;
  return box.empty() ? cv::Rect() : with_margin(box + within.tl(), survey.noisy) & within;
}

std::vector<cv::Rect> changed_places(const cv::Mat& weights, bool noisy) {
  cv::Mat labels;
  std::vector<Patch> patches = joined_patches(weights > 0, labels);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (const int label = labels.at<int>(y, x))
        patches[label - 1].weight += weights.at<float>(y, x);
  std::stable_sort(patches.begin(), patches.end(),
                   [](const Patch& a, const Patch& b) { return a.weight > b.weight; });
  std::vector<cv::Rect> places;
  for (const Patch& patch : patches)
    places.push_back(with_margin(patch.box, noisy) & cv::Rect({0, 0}, weights.size()));
  return places;
}

}  // namespace mbncc::change
