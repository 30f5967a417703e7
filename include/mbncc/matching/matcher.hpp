// SPDX-License-Identifier: BSD-3-Clause
// Finds learned objects in an image: position, rotation angle, score and covariance.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/match.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// A search request. Zero, empty or negative values select the configured ones.
struct SearchRequest {
  std::vector<std::string> names;  ///< empty: all enabled objects
  cv::Rect roi;                    ///< [px] must contain the reference points; empty: whole image
  double min_score = -1;
  int max_instances = 0;
  /// Number of objects of the whole search if this request is a part of it, with objects searched
  /// one by one. Effort and scores are then those of a joint search.
  std::size_t among = 0;
  /// For a search of a part of an image, by name: the least log-odds subtracted from scores, from
  /// SearchResult::clutter of the whole image, and the uncalibrated log-odds of the best instance
  /// outside the part.
  std::map<std::string, double> clutter, elsewhere;
  /// Instances of other objects in the image: requested objects of similar size are always
  /// verified there as well.
  std::vector<Footprint> occupied;
};

struct SearchResult {
  std::vector<Match> matches;         ///< best score first
  std::vector<std::string> searched;  ///< names that were searched
  std::vector<std::string> skipped;   ///< "name: reason"
  std::vector<std::string> limited;   ///< names with max_instances matches; there may be more
  std::vector<Rival> rivals;          ///< all candidates that are not among the matches
  std::map<std::string, double>
      clutter;  ///< by name: log-odds subtracted from scores for look-alikes elsewhere
  bool budget_exceeded = false;
  double search_time = 0;  ///< [s] wall time without preparation of objects
};

/// The names with `most` matches; none if only the best match is requested.
std::vector<std::string> names_at_limit(const std::vector<Match>& matches, int most);

/// Searches images for a set of objects. A learned point p appears at
/// (x, y) + R(theta - reference.theta) scale (p - reference).
/// find() is const and may run in several threads; the setters must not run beside it.
class Matcher {
 public:
  explicit Matcher(SearchConfig config = {});
  ~Matcher();
  Matcher(Matcher&&) noexcept;
  Matcher& operator=(Matcher&&) noexcept;

  const SearchConfig& config() const;

  /// Replaces the objects. Unchanged ones (same pointer) keep their prepared templates; the others
  /// are prepared here, in some milliseconds each. If that fails, for example for lack of memory,
  /// the object is not searched (see unsearchable()); the others are. Throws std::invalid_argument,
  /// with the objects as before, if a model violates the rules of object_model.hpp.
  /// `for_one_search`: data that only some searches need is computed in find().
  void set_objects(std::vector<std::shared_ptr<const ObjectModel>> objects,
                   bool for_one_search = false);

  /// Objects that cannot be prepared, with the reason. find() lists them in `skipped`.
  const std::map<std::string, std::string>& unsearchable() const;

  /// Objects that can be searched.
  std::vector<std::shared_ptr<const ObjectModel>> objects() const;

  /// Changes config().min_score [0..1] and config().max_instances (>= 1).
  void set_limits(double min_score, int max_instances);

  /// `image` is CV_8UC3 (bgr) or CV_8UC1, at least 16 x 16; else std::invalid_argument.
  /// A requested name that is unknown or disabled is listed in `skipped`, and so is an object that
  /// cannot be prepared.
  SearchResult find(const cv::Mat& image, const SearchRequest& request = {}) const;

  /// CV_32FC1 of the image's size, 0 .. 1: at each place the largest similarity of any requested
  /// object over all rotations, in the coarse search, for display. Objects that are searched only
  /// by their contours have none.
  cv::Mat score_map(const cv::Mat& image, const SearchRequest& request = {}) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace mbncc
