// SPDX-License-Identifier: BSD-3-Clause
// The mirrored outline of an object, to detect that the object lies on its other side.
#pragma once

#include <vector>

#include "matching/evidence/contour_alignment.hpp"
#include "matching/scene/scene_level.hpp"
#include "matching/template/contour_template.hpp"

namespace mbncc::evidence {

/// [agreement] Advantage that a mirrored outline does not reach by chance.
constexpr double kMirrored = 0.04;

class MirroredContour {
 public:
  MirroredContour() = default;

  /// For an object whose `contour` lies at `home` [px] in `lesson`.
  MirroredContour(const templates::ContourTemplate& contour, const scene::SceneLevel& lesson,
                  const Pose2D& home);

  /// Best pose of the mirrored outline, `scale` times as large, and its advantage over `contour` at
  /// `pose`, minus that in the lesson, because an outline can be its own mirror image.
  ContourAlternative alternative(const templates::ContourTemplate& contour,
                                 const scene::SceneLevel& scene, const Pose2D& pose,
                                 double scale) const;

  /// [agreement] If the advantage exceeds it, the object lies on its other side. Half of the
  /// mirrored outline's deficit in the lesson, at most kMirrored; kMirrored if the deficit is
  /// small.
  double limit() const { return limit_; }

 private:
  templates::ContourTemplate mirrored_;
  std::vector<Pose2D> poses_;  ///< of the mirrored outline that cover the object's outline best
  double usual_ = 0;           ///< advantage in the lesson
  double limit_ = kMirrored;
};

}  // namespace mbncc::evidence
