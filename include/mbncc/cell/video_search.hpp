// SPDX-License-Identifier: BSD-3-Clause
// Searches the images of one still camera only where they have changed.
#pragma once

#include <memory>
#include <opencv2/core.hpp>

#include "mbncc/config/video_config.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc {

/// Approximates Matcher::find() at a cost proportional to the change between the images:
/// - An instance whose pixels have not changed since its detection is reported again (Match::fresh
/// is false). One whose pixels changed, or whose last search was half a second ago, is searched for
/// again nearby and dropped if it is not found.
/// - A place that changed and is at rest again is searched for every object, missing ones first,
/// with a bounded effort per image. Until all have been searched there, nothing found at the
/// place is graspable, because another object may fit better.
/// - The whole image is searched for every object once per sweep_time, one object after the other,
/// which bounds how long an instance can be overlooked.
/// - If the camera is moved or the light is switched, all instances are verified and the whole
/// image is searched.
class VideoSearch {
 public:
  explicit VideoSearch(VideoConfig config = {});
  ~VideoSearch();
  VideoSearch(VideoSearch&&) noexcept;
  VideoSearch& operator=(VideoSearch&&) noexcept;

  /// Searches the next image, stamped `stamp` [s], which must not be before the last one. The
  /// objects of `matcher` may have changed since; another request, image size or limit restarts the
  /// search. Objects with places still to be searched are listed in SearchResult::skipped. Throws
  /// as Matcher::find(), and std::invalid_argument if request.part or occupied is set.
  SearchResult find(const Matcher& matcher, double stamp, const cv::Mat& image,
                    const SearchRequest& request = {});

  /// Drops all results; the next image is searched completely.
  void reset();

 private:
  struct State;
  VideoConfig config_;
  std::unique_ptr<State> state_;
};

}  // namespace mbncc
