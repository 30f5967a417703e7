// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/region_search.hpp"

#include <algorithm>
#include <cmath>

#include "imaging/rectangles.hpp"

namespace mbncc::incremental_search {
namespace {

constexpr int kMargin = 12;          // [px] margin around the searched poses
constexpr int kGrid = 16;            // [px] crops start at multiples, so that pyramids stay aligned
constexpr double kMostCrop = 0.7;    // largest crop, as a part of the image
constexpr double kLeastCost = 0.25;  // least cost of a search, relative to one of the whole image

/// Widens the range [start, start + length) within [0, end) to at least `least`, if possible.
void widen(int least, int end, int& start, int& length) {
  length = std::min(std::max(length, least), end);
  start = std::min(start, end - length);
}

void shift(SearchResult& result, cv::Point by) {
  for (auto& match : result.matches) {
    match.pose.x += by.x;
    match.pose.y += by.y;
    for (auto& point : match.outline) point += cv::Point2f(by);
    for (auto& competitor : match.competitors) competitor.position += cv::Point2d(by);
  }
  for (auto& rival : result.rivals) {
    rival.position += cv::Point2d(by);
    for (auto& point : rival.outline) point += cv::Point2f(by);
  }
}

}  // namespace

SearchResult RegionSearch::find(const cv::Rect& region, const std::vector<std::string>& names,
                                double radius, const std::map<std::string, double>& clutter,
                                const std::map<std::string, double>& elsewhere,
                                const std::vector<Footprint>& occupied) {
  const cv::Rect crop = crop_about(region, radius);
  SearchResult result;
  result.searched = names;
  if (crop.empty() || names.empty()) return result;
  SearchRequest request = request_;
  request.names = names;
  request.part = region - crop.tl();
  if (crop != whole()) {
    request.clutter = clutter;
    request.elsewhere = elsewhere;
  }
  for (auto footprint : occupied) {
    if (!crop.contains(footprint.circle.centre)) continue;
    footprint.circle.centre -= cv::Point2d(crop.tl());
    request.occupied.push_back(footprint);
  }
  result = matcher_.find(image_(crop), request);
  shift(result, crop.tl());
  const double share = static_cast<double>(crop.area()) / whole().area();
  spent_ += static_cast<double>(names.size()) * (kLeastCost + (1 - kLeastCost) * share);
  budget_exceeded_ |= result.budget_exceeded;
  return result;
}

/// Empty if no object there can touch the image.
cv::Rect RegionSearch::crop_about(const cv::Rect& region, double radius) const {
  const int around = static_cast<int>(std::ceil(radius)) + kMargin;
  cv::Rect wanted = imaging::grown(region, around) & whole();
  if (wanted.empty()) return wanted;
  // At the image's border, too, the crop must be large enough for the object's pyramid.
  widen(2 * around, image_.cols, wanted.x, wanted.width);
  widen(2 * around, image_.rows, wanted.y, wanted.height);
  const cv::Point low(wanted.x / kGrid * kGrid, wanted.y / kGrid * kGrid);
  const cv::Rect crop = cv::Rect(low, wanted.br()) & whole();
  return crop.area() < kMostCrop * whole().area() ? crop : whole();
}

}  // namespace mbncc::incremental_search
