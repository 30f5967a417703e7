// A pose at full resolution, climbed to on contour and surface.
#pragma once

#include "matching/climb.hpp"
#include "matching/prepared_object.hpp"
#include "matching/scene_picture.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc {

/// Log-odds: poses of less have never become a detection.
constexpr double kWorthRefining = -4;

/// A pose at full resolution with the evidence for it.
struct Believed {
  Pose2D pose;
  Evidence evidence;
  double odds = 0;    ///< log-odds that the object lies here
  double pixels = 0;  ///< log-odds that all pixels of a small object add
  int refining = 0;   ///< steps that its refinement may take
};

/// The evidence for a pose as it is.
Believed believed_as_is(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose);

/// Of two poses at one place the one that light prefers less: they compete like rotations, see
/// compare_rotations().
Believed better_turned(const Believed& a, const Believed& b);

/// The best pose that climbs from this one and slightly turned ones reach.
Believed polished(const PreparedView& view, const ScenePicture& scene, const Pose2D& pose);

/// A polished pose, for a small object settled where all of its pixels fit best.
Believed settled(const PreparedView& view, const ScenePicture& scene, const Believed& start);

}  // namespace mbncc
