// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/region_search.hpp"

#include <cmath>

#include "imaging/rectangles.hpp"

namespace mbncc::incremental_search {
namespace {

constexpr int kMargin = 12;          // [px] margin around the searched poses
constexpr int kGrid = 16;            // [px] crops start at multiples, so that pyramids stay aligned
constexpr double kMostCrop = 0.7;    // largest crop, as a part of the image
constexpr double kLeastCost = 0.25;  // least cost of a search, relative to one of the whole image

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
  cv::Rect roi = region & whole();
  if (!request_.roi.empty()) roi &= request_.roi;
  SearchResult result;
  result.searched = names;
  if (roi.empty() || names.empty()) return result;
  const cv::Rect crop = crop_about(region, radius);
  SearchRequest request = request_;
  request.names = names;
  request.roi = roi - crop.tl();
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

cv::Rect RegionSearch::crop_about(const cv::Rect& region, double radius) const {
  const cv::Rect wanted =
      imaging::grown(region, static_cast<int>(std::ceil(radius)) + kMargin) & whole();
  const cv::Point low(wanted.x / kGrid * kGrid, wanted.y / kGrid * kGrid);
  const cv::Rect crop(low, wanted.br());
  return crop.area() < kMostCrop * whole().area() ? crop : whole();
}

}  // namespace mbncc::incremental_search
