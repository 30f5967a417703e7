// SPDX-License-Identifier: BSD-3-Clause
// Searches a part of an image, at the cost of a part.
#pragma once

#include <map>
#include <opencv2/core.hpp>
#include <string>
#include <utility>
#include <vector>

#include "mbncc/matching/matcher.hpp"

namespace mbncc::incremental_search {

/// Searches of one image, which `matcher` and `image` outlive.
class RegionSearch {
 public:
  /// `request` limits all searches and sets the search effort; its names are ignored.
  RegionSearch(const Matcher& matcher, const cv::Mat& image, SearchRequest request)
      : matcher_(matcher), image_(image), request_(std::move(request)) {}

  cv::Rect whole() const { return cv::Rect({0, 0}, image_.size()); }

  /// Searches for reference points in `region` [px], in as little of the image as objects of
  /// `radius` [px] take. `clutter` as SearchResult::clutter told of the whole image, `elsewhere`
  /// and `occupied` as of SearchRequest.
  SearchResult find(const cv::Rect& region, const std::vector<std::string>& names, double radius,
                    const std::map<std::string, double>& clutter,
                    const std::map<std::string, double>& elsewhere,
                    const std::vector<Footprint>& occupied);

  /// So far, in searches of one object in the whole image.
  double spent() const { return spent_; }

  /// The time budget ended a search early.
  bool budget_exceeded() const { return budget_exceeded_; }

 private:
  cv::Rect crop_about(const cv::Rect& region, double radius) const;

  const Matcher& matcher_;
  const cv::Mat& image_;
  const SearchRequest request_;
  double spent_ = 0;
  bool budget_exceeded_ = false;
};

/// `rect` with `by` [px] more on every side.
cv::Rect grown(const cv::Rect& rect, int by);

}  // namespace mbncc::incremental_search
