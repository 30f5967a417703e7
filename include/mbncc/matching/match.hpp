// SPDX-License-Identifier: BSD-3-Clause
// Instances of learned objects found in an image.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mbncc/geometry.hpp"
#include "mbncc/matching/log_odds.hpp"

namespace mbncc {

/// A competitor of a match: another object at its place, or another place of the same object.
struct Competitor {
  std::string name;
  cv::Point2d position;  ///< [px] of its reference point
  double log_odds = 0;   ///< comparable with Match::log_odds() of the match
};

/// A reason against grasping a match.
struct Doubt {
  bool ambiguous =
      false;  ///< true: another pose may be the right one; false: this pose is too uncertain
  std::string text;
};

/// One instance of a learned object in one image.
struct Match {
  std::string name;
  std::uint32_t revision = 0;
  Pose2D pose;  ///< [px],[rad] object frame: reference point and direction
  double scale =
      1;  ///< relative to the learning image; the searched scale unless another is significant
  cv::Matx33d covariance;  ///< of pose: x, y, theta [px^2, px rad, rad^2]; 100 px and a full turn
                           ///< if the pose is too unlikely to be measured
  double score = 0;        ///< [0..1] acceptance score
  LogOdds odds;            ///< that the object lies at the pose
  double similarity = 0;   ///< [-1..1] normalized cross correlation weighted by the map
  /// The best place of the same object that is no other instance, and the best other object at this
  /// place.
  std::vector<Competitor> competitors;
  /// Log-odds of this match minus those of its best competitor; 20: none was found.
  double margin_place = 0;
  /// Log-odds of this match minus those of the best other angle at this place (more than 10 degrees
  /// away, modulo the symmetry); 20: none was found.
  double margin_angle = 0;
  std::optional<double> other_angle;  ///< [rad] object frame at that angle; empty: none
  double visible = 1;                 ///< [0..1] part of the map inside the image
  int symmetry = 1;                   ///< 1: none, 2: 180 deg ..., 0: round
  /// [px] Unless `symmetry` is 1: from the reference point to the point about which turns by a part
  /// of the symmetry leave the object as it is.
  cv::Point2d to_symmetry_centre;
  std::vector<Doubt> doubts;  ///< reasons against grasping apart from competitors
  /// All conditions for a grasp hold in this image: score, margins, visible part, standard
  /// deviations, colours of parts, print, size, nothing larger that the object is a part of, no
  /// better fit of the outline
  /// nearby, mirrored or torn, and a probability of at least .98.
  bool graspable = false;
  bool ambiguous = false;  ///< the score suffices, but another pose or object may be there
  std::vector<std::string> reasons;  ///< why it is not graspable; empty if it is
  bool fresh = true;  ///< found in this image; otherwise in an earlier one with unchanged pixels
  std::vector<cv::Point2f> outline;  ///< [px] largest outline of the map in this image

  double log_odds() const { return odds.total(); }
};

/// `match` at another of the poses that its symmetry makes equivalent, turned about the centre of
/// symmetry: the one whose angle is the nearest to `theta` [rad].
Match equivalent_towards(double theta, Match match);

/// A candidate that was considered but not reported, because it is weak, overlaps a better one, or
/// lies outside SearchRequest::part.
struct Rival {
  std::string name;
  cv::Point2d position;  ///< [px] of its reference point
  LogOdds odds;
  std::vector<cv::Point2f> outline;  ///< [px] see Match::outline
  bool in_part = true;               ///< its reference point lies in SearchRequest::part

  /// Without calibration.
  double log_odds() const { return odds.uncalibrated(); }
};

/// The place and size of an outline.
struct Footprint {
  Circle circle;    ///< [px] smallest circle around it
  double area = 0;  ///< [px] within it, holes included
};

/// Largest number of requested objects for which a search without result is repeated thoroughly.
constexpr std::size_t kFewObjects = 4;

}  // namespace mbncc
