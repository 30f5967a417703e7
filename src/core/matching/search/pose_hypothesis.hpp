// SPDX-License-Identifier: BSD-3-Clause
// A pose at full resolution, climbed to on contour and surface.
#pragma once

#include "matching/prepared/prepared_object.hpp"
#include "matching/refinement/gauss_newton.hpp"
#include "matching/scene/scene_picture.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc {

/// Log-odds: poses of less have never become a detection.
constexpr double kWorthRefining = -4;

/// A pose at full resolution with the evidence for it.
struct PoseHypothesis {
  Pose2D pose;
  Evidence evidence;
  double odds = 0;    ///< log-odds that the object lies here
  double pixels = 0;  ///< log-odds that all pixels of a small object add
  int refining = 0;   ///< steps that its refinement may take
};

/// The evidence for a pose as it is.
PoseHypothesis score_as_is(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose);

/// Of two poses at one place the one that light prefers less: they compete like rotations, see
/// compare_rotations().
PoseHypothesis better_rotation(const PoseHypothesis& a, const PoseHypothesis& b);

/// The best pose that alignments from this one and slightly turned ones reach.
PoseHypothesis multistart_align(const PreparedView& view, const ScenePicture& scene,
                                const Pose2D& pose);

/// A polished pose, for a small object settled where all of its pixels fit best.
PoseHypothesis finalised(const PreparedView& view, const ScenePicture& scene,
                         const PoseHypothesis& start);

}  // namespace mbncc
