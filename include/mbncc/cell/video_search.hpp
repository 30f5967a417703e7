// SPDX-License-Identifier: BSD-3-Clause
// Searches the pictures of one still camera: where nothing has changed, nothing is searched.
#pragma once

#include <memory>
#include <opencv2/core.hpp>

#include "mbncc/config/video_config.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc {

/// Finds what Matcher::find() would find, at a cost that follows the change between the pictures:
/// - An instance whose pixels look as they did when it was found is still there (Match::fresh is
///   false). One whose pixels changed is searched for anew nearby, and dropped when it is gone.
/// - A place that changed and has come to rest is searched for every object, those missing first,
///   with a bounded effort per picture. Until all have been searched there, nothing found at the
///   place is graspable: another object may fit better.
/// - Every object is searched for in the whole picture once in sweep_time, in turn: nothing can be
///   overlooked for longer.
/// - When the camera is pushed or the light switched, all instances are verified and the whole
///   picture is searched.
class VideoSearch {
 public:
  explicit VideoSearch(VideoConfig config = {});
  ~VideoSearch();
  VideoSearch(VideoSearch&&) noexcept;
  VideoSearch& operator=(VideoSearch&&) noexcept;

  /// The next picture, stamped `stamp` [s], not before the last one. `matcher` may have got other
  /// objects since; another request, picture size or limit starts anew. Objects with places still
  /// to be searched are listed in SearchResult::skipped. Throws as Matcher::find().
  SearchResult find(const Matcher& matcher, double stamp, const cv::Mat& picture,
                    const SearchRequest& request = {});

  /// Forgets what was found; the next picture is searched whole.
  void reset();

 private:
  struct State;
  VideoConfig config_;
  std::unique_ptr<State> state_;
};

}  // namespace mbncc
