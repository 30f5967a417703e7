// SPDX-License-Identifier: BSD-3-Clause
// Searches with the newest state of the library, which may change at any time.
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

/// A search result and the library used.
struct Found {
  SearchResult result;
  SharedLibrary::Snapshot library;
};

class LiveMatcher {
 public:
  /// Throws FileError when the library folder cannot be used.
  LiveMatcher(const SearchConfig& config, const std::string& library_path);

  /// The settings apply to every search from now on, see Matcher::configure(). Returns true if they
  /// differ from the current ones.
  bool configure(const SearchConfig& config);

  /// Searches objects learned in images of this size; the others, and those that cannot be
  /// searched, are listed as skipped. The least recently searched come first, so that a time budget
  /// does not always exclude the same ones. Nothing is searched while the library cannot be read,
  /// because deleted objects must not be found. Thread-safe.
  Found find(const cv::Mat& image, SearchRequest request) const;

  /// Like find(), for the next image of the video that `video` searches; `stamp` [s] is that of the
  /// image.
  Found watch(VideoSearch& video, double stamp, const cv::Mat& image, SearchRequest request) const;

  /// See Matcher::score_map(), for all enabled objects. Thread-safe.
  cv::Mat score_map(const cv::Mat& image) const;

  /// Checks the library folder for changes; `always`: reads it in any case. Throws FileError; then
  /// find() finds nothing until the folder can be read again.
  void refresh(bool always) { library_.refresh(always); }

  /// Why some or all objects are not searched; "" without a fault.
  std::string fault() const;

  SharedLibrary::Snapshot library() const { return library_.snapshot(); }
  const std::string& folder() const { return library_.folder(); }

 private:
  void take_over(const SharedLibrary::Snapshot& snapshot);
  Found nothing_found(const std::vector<std::string>& names, const std::string& reason) const;

  /// Searches overlap, so that a writer might otherwise wait for ever for a moment without any, and
  /// deleted objects would be found meanwhile. A writer that waits keeps further readers waiting.
  std::shared_lock<std::shared_mutex> reading() const;
  std::unique_lock<std::shared_mutex> writing();

  void sort_least_recent_first(std::vector<std::string>& names) const;
  void note_searched(const std::vector<std::string>& names) const;

  mutable std::mutex searches_mutex_;
  mutable std::map<std::string, std::uint64_t> last_search_;  // last search of each object
  mutable std::uint64_t searches_ = 0;
  mutable std::mutex turn_;  // held while waiting for mutex_
  mutable std::shared_mutex mutex_;
  Matcher matcher_;
  SharedLibrary::Snapshot searched_;  // the library whose objects matcher_ holds
  SharedLibrary library_;
};

}  // namespace mbncc::nodelets
