// SPDX-License-Identifier: BSD-3-Clause
#include "matching/polar_engine.hpp"

#include <opencv2/imgproc.hpp>

#include "imaging/pyramid.hpp"
#include "matching/suppression.hpp"

namespace mbncc::bench {

void PolarEngine::teach(const cv::Mat& image, const cv::Mat& map, cv::Point2d reference) {
  const View view = crop_view(image, map, {reference.x, reference.y, 0});
  search_.emplace(view, region_);
  lever_ = reference - (search_->centre() + cv::Point2d(view.origin));
  apart_ = excircle(map).radius / 2;
}

std::vector<Found> PolarEngine::find(const cv::Mat& image) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  const auto levels = imaging::build_pyramid(grey, search_->top_level());
  if (static_cast<int>(levels.size()) <= search_->top_level()) return {};
  std::vector<Found> found;
  for (const auto& peak : search_->find(levels, {{0, 0}, grey.size()})) {
    const cv::Point2d at = transform(peak.pose, lever_);
    found.push_back({{at.x, at.y, peak.pose.theta}, peak.similarity, false, {}});
  }
  return without_neighbours(std::move(found), apart_);
}

}  // namespace mbncc::bench
