// SPDX-License-Identifier: BSD-3-Clause
// Finds learned objects in an image: position, rotation angle, score and covariance.
#pragma once

#include <map>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/match.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// A search request. Its defaults select what is configured.
struct SearchRequest {
  std::vector<std::string> names;  ///< empty: all enabled objects
  /// [px] Only matches whose reference points lie in it are reported, symmetric objects at an
  /// equivalent pose. It limits no search, because what lies outside competes and counts as
  /// clutter. May exceed the image. Empty: everywhere.
  cv::Rect roi;
  double min_score = -1;  ///< negative: the configured one, or the object's own
  int max_instances = 0;  ///< 0: the configured one
  /// Total number of objects if this request is part of a larger search whose objects are searched
  /// one by one. Search budget and scores are then those of a joint search, without its colour
  /// prefilters and white balance.
  std::size_t among = 0;
  /// [px] Limits the search to reference points in it, for a caller who knows what lies outside:
  /// see `clutter` and `elsewhere`. Empty: the whole image is searched.
  cv::Rect part;
  /// Whether the image is grey, so that colours cannot be compared; without a value, its pixels
  /// tell. Those of a part of a colour image may all be grey.
  std::optional<bool> is_grey;
  /// For a search in part of an image, by object name. `clutter`: least log-odds to subtract from
  /// scores, taken from SearchResult::clutter of the whole image. `elsewhere`: uncalibrated
  /// log-odds of the best instance outside the part.
  std::map<std::string, double> clutter, elsewhere;
  /// Instances of other objects in the image. Requested objects of similar size are also verified
  /// at these places.
  std::vector<Footprint> occupied;
};

struct SearchResult {
  std::vector<Match> matches;         ///< best score first
  std::vector<std::string> searched;  ///< names that were searched
  std::vector<std::string> skipped;   ///< "name: reason"
  std::vector<std::string> limited;   ///< names of which there may be more, see names_at_limit()
  std::vector<Rival> rivals;          ///< all candidates that are no matches in the whole image
  std::map<std::string, double>
      clutter;  ///< by name: log-odds subtracted from scores because of look-alikes elsewhere
  bool budget_exceeded = false;
  double search_time = 0;  ///< [s] wall time, without preparation of objects
};

/// The names with `most` matches; if only the best match is requested, those that probably lie
/// at another place, too.
std::vector<std::string> names_at_limit(const std::vector<Match>& matches, int most);

/// Why an object that was learned in images of another size is not searched for in images of this
/// `size`; "" if the sizes are equal.
std::string other_image_size(const ObjectModel& object, cv::Size size);

/// Searches images for a set of objects. A learned point p appears at
/// (x, y) + R(theta - reference.theta) scale (p - reference).
/// find() may run in several threads at once; the setters must not run concurrently with it.
class Matcher {
 public:
  explicit Matcher(SearchConfig config = {});
  ~Matcher();
  Matcher(Matcher&&) noexcept;
  Matcher& operator=(Matcher&&) noexcept;

  const SearchConfig& config() const;

  /// Replaces the objects. Unchanged ones (same pointer) keep their prepared templates; the others
  /// are prepared here, which takes a few milliseconds each. If that fails, for example for lack of
  /// memory, the object is not searched (see unsearchable()); the others are. Throws
  /// std::invalid_argument and keeps the previous objects if a model violates the rules of
  /// object_model.hpp. If `for_one_search`, data that only some searches need is computed in
  /// find().
  void set_objects(std::vector<std::shared_ptr<const ObjectModel>> objects,
                   bool for_one_search = false);

  /// Enabled objects that cannot be prepared, with the reason. find() lists them in `skipped`.
  const std::map<std::string, std::string>& unsearchable() const;

  /// The same and those too large for images of this size [px].
  std::map<std::string, std::string> unsearchable_in(cv::Size image) const;

  /// Objects that can be searched.
  std::vector<std::shared_ptr<const ObjectModel>> objects() const;

  /// Changes all settings but `engine` and `scale_range`, for which the objects were prepared.
  void configure(SearchConfig config);

  /// `image` is CV_8UC3 (bgr) or CV_8UC1, at least 16 x 16; otherwise throws
  /// std::invalid_argument. Requested names that are unknown or disabled and the objects of
  /// unsearchable_in() are listed in `skipped`.
  SearchResult find(const cv::Mat& image, const SearchRequest& request = {}) const;

  /// For display: CV_32FC1 of the image's size with, at each place, the largest similarity [0..1]
  /// in the coarse search over all requested objects and rotations. Objects that are searched only
  /// by their contours do not contribute.
  cv::Mat score_map(const cv::Mat& image, const SearchRequest& request = {}) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace mbncc
