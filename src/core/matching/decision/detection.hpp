// SPDX-License-Identifier: BSD-3-Clause
// A verified pose, and the competition of rotations at one place.
#pragma once

#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/template/view_frame.hpp"
#include "mbncc/geometry.hpp"
#include "mbncc/matching/log_odds.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::decision {

/// Detection::contour_alternative of a detection whose outline was not tested at other places,
/// because its score is low or it is not the best at its place. Larger than any
/// advantage_elsewhere().
constexpr double kNotExamined = 4;

/// A pose with its evidence, refined if it may be reported.
struct Detection {
  const ObjectModel* object = nullptr;
  const templates::ViewFrame* view = nullptr;  ///< the view that was found
  std::size_t view_number = 0;                 ///< index in PreparedObject::views
  Pose2D pose;                                 ///< of the view's anchor [px],[rad]
  double scale = 1;                            ///< of the object, relative to the view
  cv::Matx33d covariance;                      ///< of pose
  cv::Matx33d grasp_covariance;                ///< covariance for the grasp conditions, see Refined
  double scale_variance = 0;                   ///< see Refined
  LogOdds odds;                                ///< that the object lies at the pose
  double similarity = 0;                       ///< [-1..1]
  double visible = 1;                          ///< [0..1]
  bool size_alternative = false;    ///< a size fits that heights and tilts do not explain
  bool mirror_alternative = false;  ///< its mirrored outline fits better
  double colour_difference = 0;     ///< see ColourParts::worst_difference()
  /// See PrintDifference::largest; compared when the pose is refined.
  double print_difference = std::numeric_limits<double>::infinity();
  double edge_difference = std::numeric_limits<double>::infinity();  ///< see InteriorEdges
  /// See PrintComparison::difference_in_detail().
  double detail_difference = std::numeric_limits<double>::infinity();
  double continued = 0;  ///< see MissingContrast; of the best pose at its place
  double absent = 0;     ///< the same; only the best pose at a place is examined
  bool torn = false;     ///< the same: rows or parts of its outline are displaced
  double contour_alternative = kNotExamined;  ///< see advantage_elsewhere()
  double rotation_odds = 0;  ///< against other rotations at this place, see rotation_odds()
  std::size_t number = 0;    ///< index among the poses verified together

  /// Log-odds without calibration.
  double log_odds() const { return odds.uncalibrated(); }
};

/// Rotations at one place compete if their log-odds are at most this far below the best. Their
/// print penalty does not count, because gloss may cause it at one rotation and not at another. A
/// mirrored object competes if its log-odds are at most this far below those of the pose.
constexpr double kComparable = 8;

/// Overlap of two maps [0..1] of the smaller one from which on they compete for one place.
constexpr double kOnePlace = 0.25;

/// Whether two detections overlap by more than `most` [0..1] of the smaller map.
bool overlapping(const Detection& a, const Detection& b, double most);

/// Whether two detections are at one place, however far their anchors lie apart: an object with a
/// handle covers most of itself after half a turn. Long parts side by side lie at two.
bool at_one_place(const Detection& a, const Detection& b);

/// Reference point [px] relative to the anchor, at the scale of the detection.
cv::Point2d lever_of(const Detection& detection);

/// Pose of the object frame.
Pose2D object_pose(const Detection& detection);

/// The view's largest outline at the detection. [px]
std::vector<cv::Point2f> outline_at(const Detection& detection);

/// Pose of the object frame; if its reference point does not lie in `region` [px] (empty:
/// everywhere), an equivalent pose of a symmetric object whose reference point does. Of a round
/// object, the one whose reference point is the nearest to the middle of the region is tried.
Pose2D object_pose_within(const Detection& detection, const cv::Rect& region);

/// Whether the reference point lies in `region`, of a symmetric object at an equivalent pose.
bool reference_within(const Detection& detection, const cv::Rect& region);

/// Ranks detections at the same place by their rotation_odds: the best one gets the group's largest
/// log-odds, and the others keep their differences in rotation_odds. Returns best first.
std::vector<Detection> resolve_rotations(std::vector<Detection> detections);

}  // namespace mbncc::decision
