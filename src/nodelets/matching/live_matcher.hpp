// SPDX-License-Identifier: BSD-3-Clause
// Matcher and library together: searches with the newest library while that may change.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <opencv2/core.hpp>
#include <shared_mutex>
#include <string>
#include <vector>

#include "mbncc/cell/video_search.hpp"
#include "mbncc/matching/matcher.hpp"
#include "nodelets/library/shared_library.hpp"

namespace mbncc::nodelets {

/// A search and the library it was made with.
struct Found {
  SearchResult result;
  SharedLibrary::Snapshot library;
};

class LiveMatcher {
 public:
  /// Throws FileError when the library folder cannot be used.
  LiveMatcher(const SearchConfig& config, const std::string& library_path);

  /// For every search from now on; true when that changes anything. Where more changes than
  /// min_score and max_instances, the objects are prepared anew, which takes some milliseconds
  /// each.
  bool configure(const SearchConfig& config);

  /// Searches for objects learned in pictures of this size; the others, and those that cannot be
  /// searched for, are listed as skipped. The least recently searched come first, so that with a
  /// time budget each has its turn. Nothing is searched for while the library cannot be read: what
  /// was deleted meanwhile must not be found. Safe from several threads.
  Found find(const cv::Mat& picture, SearchRequest request) const;

  /// As find(), with the next picture, stamped `stamp` [s], of the video that `video` watches.
  Found watch(VideoSearch& video, double stamp, const cv::Mat& picture,
              SearchRequest request) const;

  /// See Matcher::score_map(), for all enabled objects. Safe from several threads.
  cv::Mat score_map(const cv::Mat& picture) const;

  /// Looks for changes in the library folder; `always`: reads it in any case. Throws FileError;
  /// then find() finds nothing until the folder can be read again.
  void refresh(bool always);

  /// Why some objects, or all, are not searched for; "" when nothing is wrong.
  std::string fault() const;

  SharedLibrary::Snapshot library() const { return library_.snapshot(); }
  const std::string& folder() const { return library_.folder(); }

 private:
  void take_over(const SharedLibrary::Snapshot& snapshot);
  void note_unreadable(const std::string& reason);
  Found nothing_found(const std::vector<std::string>& names) const;

  void sort_by_turn(std::vector<std::string>& names) const;
  void note_searched(const std::vector<std::string>& names) const;

  mutable std::mutex turns_mutex_;
  mutable std::map<std::string, std::uint64_t> last_turn_;  // by name
  mutable std::uint64_t turns_ = 0;
  mutable std::shared_mutex mutex_;
  Matcher matcher_;
  SharedLibrary::Snapshot searched_;  // what matcher_ holds
  std::string unreadable_;            // why the library cannot be read; "": it can
  SharedLibrary library_;
};

}  // namespace mbncc::nodelets
