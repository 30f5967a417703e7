// SPDX-License-Identifier: BSD-3-Clause
// Finds learned objects in a picture: position, rotation angle, score and how sure that is.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// What might lie where a match is reported, or be meant instead of it.
struct Competitor {
  std::string name;
  cv::Point2d position;  ///< [px] of its reference point
  double log_odds = 0;   ///< on the scale of the match that it competes with
};

/// Something that speaks against grasping a match.
struct Doubt {
  bool ambiguous = false;  ///< another pose may be the right one; else this one is too uncertain
  std::string text;
};

/// One instance of a learned object in one picture.
struct Match {
  std::string name;
  std::uint32_t revision = 0;
  Pose2D pose;       ///< [px],[rad] object frame: reference point and direction
  double scale = 1;  ///< relative to the learning picture; that searched unless another is clear
  cv::Matx33d covariance;  ///< of pose: x, y, theta [px^2, px rad, rad^2]; 100 px, a turn
                           ///< where it is too unlikely to be worth measuring
  double score = 0;        ///< [0..1] acceptance score
  double log_odds = 0;     ///< that the object lies here; the fused score is its logistic
  double calibration = 0;  ///< part of log_odds that comparisons with competitors leave out
  double similarity = 0;   ///< [-1..1] normalized cross correlation weighted by the map
  /// The best place of the same object that no reported instance explains, and the best other
  /// object here.
  std::vector<Competitor> competitors;
  /// Log-odds to the best competitor; 20: none was found.
  double margin_place = 0;
  /// Log-odds to the best other angle here (more than 10 degrees off, symmetry aside).
  double margin_angle = 0;
  double visible = 1;         ///< [0..1] part of the map inside the picture
  int symmetry = 1;           ///< 1: none, 2: 180 deg ..., 0: round
  std::vector<Doubt> doubts;  ///< about this pose, competitors aside
  /// Nothing speaks against the pose in this picture: score, margins, visible part, deviations,
  /// colours of parts, size, and where else or mirrored the outline would fit.
  bool graspable = false;
  bool ambiguous = false;            ///< score would suffice, but another pose may be the right one
  std::vector<std::string> reasons;  ///< why it is not graspable; empty when it is
  bool fresh = true;  ///< found in this picture; else in an earlier one that looked the same
  std::vector<cv::Point2f> outline;  ///< [px] largest outline of the map in this picture

  double uncalibrated() const { return log_odds - calibration; }
};

/// What was considered and not reported.
struct Rival {
  std::string name;
  cv::Point2d position;              ///< [px] of its reference point
  double log_odds = 0;               ///< comparable with Match::uncalibrated()
  std::vector<cv::Point2f> outline;  ///< [px] as of Match
};

/// Up to so many objects asked for at once are looked for thoroughly where a first look finds none.
constexpr std::size_t kFewObjects = 4;

/// The place and size of an outline.
struct Footprint {
  Circle circle;    ///< [px] about it
  double area = 0;  ///< [px] within it, holes included
};

/// What to search for. Zero, empty or negative values mean: as configured.
struct SearchRequest {
  std::vector<std::string> names;  ///< empty: all enabled objects
  cv::Rect roi;  ///< [px] reference points are looked for in here; empty: whole picture
  double min_score = -1;
  int max_instances = 0;
  /// The request is part of a search for so many objects, which are looked for one by one: none is
  /// looked for harder, and none scores higher, than if all were looked for at once.
  std::size_t among = 0;
  /// For a search of part of a picture: by name, the log-odds that scores are lowered by at least,
  /// as SearchResult::clutter told of the whole, and those of the best instance outside the part,
  /// uncalibrated.
  std::map<std::string, double> clutter, elsewhere;
  /// Instances of other objects that the picture shows: whether an object asked for, of that size,
  /// lies there instead is judged in any case.
  std::vector<Footprint> occupied;
};

struct SearchResult {
  std::vector<Match> matches;             ///< best score first
  std::vector<std::string> searched;      ///< names really searched
  std::vector<std::string> skipped;       ///< "name: reason"
  std::vector<std::string> limited;       ///< names with max_instances matches: there may be more
  std::vector<Rival> rivals;              ///< all that is not among the matches
  std::map<std::string, double> clutter;  ///< by name: log-odds that scores were lowered by, for
                                          ///< what looks alike elsewhere
  bool budget_exceeded = false;
  double search_time = 0;  ///< [s] wall time, preparation of objects not included
};

/// The names of which there are `most` matches; none where only the best one is asked for.
std::vector<std::string> names_at_limit(const std::vector<Match>& matches, int most);

/// Searches pictures for a set of objects. A learned point p appears at
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
  /// are prepared here, which takes some milliseconds each; where that fails, e.g. for want of
  /// memory, the object is not searched for, see unsearchable(), and the others are. Throws
  /// std::invalid_argument, with the objects as before, when a model breaks the rules of
  /// object_model.hpp. `for_one_search`: what only some searches need is left to find().
  void set_objects(std::vector<std::shared_ptr<const ObjectModel>> objects,
                   bool for_one_search = false);

  /// Objects that cannot be prepared, with the reason. find() lists them in `skipped`.
  const std::map<std::string, std::string>& unsearchable() const;

  /// Those that can be searched for.
  std::vector<std::shared_ptr<const ObjectModel>> objects() const;

  /// Changes config().min_score [0..1] and config().max_instances (>= 1).
  void set_limits(double min_score, int max_instances);

  /// `picture` is CV_8UC3 (bgr) or CV_8UC1, at least 16 x 16; else std::invalid_argument.
  /// A requested name that is unknown or disabled is listed in `skipped`, and so is an object that
  /// cannot be prepared.
  SearchResult find(const cv::Mat& picture, const SearchRequest& request = {}) const;

  /// CV_32FC1 of the picture's size, 0 .. 1: at each place the largest similarity of any requested
  /// object over all rotations, as the coarse search sees it. For people to look at. Objects that
  /// are searched by their edges alone have none.
  cv::Mat score_map(const cv::Mat& picture, const SearchRequest& request = {}) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace mbncc
