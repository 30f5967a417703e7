// Matcher and library together: searches with the newest library while that may change.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <shared_mutex>
#include <string>

#include "mbncc/matching/matcher.hpp"
#include "nodelets/shared_library.hpp"

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

  /// For every search from now on; [0..1], and per name.
  void set_limits(double min_score, int max_instances);

  /// Searches for objects learned in pictures of this size; the others are listed as skipped. Safe
  /// from several threads.
  Found find(const cv::Mat& picture, SearchRequest request) const;

  /// Looks for changes in the library folder; `always`: reads it in any case. Throws FileError.
  void refresh(bool always);

  SharedLibrary::Snapshot library() const { return library_.snapshot(); }
  const std::string& folder() const { return library_.folder(); }

 private:
  void take_over(const SharedLibrary::Snapshot& snapshot);

  mutable std::shared_mutex mutex_;
  Matcher matcher_;
  SharedLibrary::Snapshot searched_;  // what matcher_ holds
  SharedLibrary library_;
};

}  // namespace mbncc::nodelets
