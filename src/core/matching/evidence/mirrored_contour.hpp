// SPDX-License-Identifier: BSD-3-Clause
// The mirrored outline of an object, to detect that the object lies on its other side.
#pragma once

#include <vector>

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

  /// A pose of the mirrored outline.
  struct Alternative {
    Pose2D pose;
    double advantage;  ///< [-4..2] in contour_agreement() over the object's own outline
  };

  /// Poses at which the mirrored outline, `scale` times as large, covers `contour` at `pose` best.
  /// Their advantages are less by that in the lesson, because an outline can be its own mirror
  /// image.
  std::vector<Alternative> alternatives(const templates::ContourTemplate& contour,
                                        const scene::SceneLevel& scene, const Pose2D& pose,
                                        double scale) const;

  /// [agreement] If an advantage exceeds it, the object lies on its other side. Half of the
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
