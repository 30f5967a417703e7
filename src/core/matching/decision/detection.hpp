// SPDX-License-Identifier: BSD-3-Clause
// A pose that was judged, and rotations at one place that compete.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/prepared/prepared_object.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc {

/// [agreement] Of a detection whose outline was not looked for elsewhere, since it is not likely,
/// or not the best of its place: it may lie better there.
constexpr double kNotExamined = 4;

/// A pose with what speaks for it, refined where it may be reported.
struct Detection {
  const PreparedObject* object = nullptr;
  const PreparedView* view = nullptr;
  Pose2D pose;                      ///< of the anchor [px]
  double size = 1;                  ///< of what was found, against the view
  cv::Matx33d covariance;           ///< of pose
  cv::Matx33d cautious;             ///< likewise, see Refined: a grasp is judged by it
  double log_odds = 0;              ///< that the object lies here
  double similarity = 0;            ///< [-1..1]
  double visible = 1;               ///< [0..1]
  double strange = 0;               ///< [0..2] see ColourDifference, the larger one
  bool another_size = false;        ///< would fit better were it smaller or larger
  bool turned_over = false;         ///< its mirrored outline would lie better
  bool torn = false;                ///< so would parts of its outline that lie apart
  double elsewhere = kNotExamined;  ///< see better_elsewhere()
  double calibration = 0;           ///< log-odds, see calibration()
  double projected = 0;             ///< [-1..1] see Evidence
  double rotation_odds = 0;         ///< against other rotations here, see rotation_odds()
  std::size_t number = 0;           ///< among the poses that were judged together

  /// Log-odds that the pose is right.
  double calibrated() const { return log_odds + calibration; }
  double score() const;  ///< [0..1]
};

/// Log-odds behind the best rotation at a place within which others compete with it.
constexpr double kComparable = 8;

/// One of the places of two detections would do for both.
bool at_one_place(const Detection& a, const Detection& b);

/// Lets detections at the same place compete by their rotation_odds: the best of them takes the
/// group's log-odds, and the others follow by as much as they are behind. Returns best first.
std::vector<Detection> compare_rotations(std::vector<Detection> detections);

}  // namespace mbncc
