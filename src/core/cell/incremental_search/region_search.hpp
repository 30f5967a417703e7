// SPDX-License-Identifier: BSD-3-Clause
// Searches a part of an image at a cost that decreases with the part's size.
#pragma once

#include <map>
#include <opencv2/core.hpp>
#include <string>
#include <utility>
#include <vector>

#include "mbncc/matching/matcher.hpp"

namespace mbncc::incremental_search {

/// Searches one image. `matcher` and `image` must outlive it.
class RegionSearch {
 public:
  /// `request` limits and scores all searches; its names and regions are ignored.
  RegionSearch(const Matcher& matcher, const cv::Mat& image, SearchRequest request)
      : matcher_(matcher), image_(image), request_(std::move(request)) {}

  cv::Rect whole() const { return cv::Rect({0, 0}, image_.size()); }

  /// Searches for objects whose reference points lie in `region` [px], which may exceed the image,
  /// in a crop just large enough for objects of `radius` [px]. `clutter` is SearchResult::clutter
  /// of the whole image; `elsewhere` and `occupied` are as in a SearchRequest for the whole image.
  SearchResult find(const cv::Rect& region, const std::vector<std::string>& names, double radius,
                    const std::map<std::string, double>& clutter,
                    const std::map<std::string, double>& elsewhere,
                    const std::vector<Footprint>& occupied);

  /// Cost so far; a search of the whole image for one object costs 1.
  double spent() const { return spent_; }

  /// Whether the time budget ended a search early.
  bool budget_exceeded() const { return budget_exceeded_; }

 private:
  cv::Rect crop_about(const cv::Rect& region, double radius) const;

  const Matcher& matcher_;
  const cv::Mat& image_;
  const SearchRequest request_;
  double spent_ = 0;
  bool budget_exceeded_ = false;
};

}  // namespace mbncc::incremental_search
