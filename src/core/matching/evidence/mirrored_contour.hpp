// SPDX-License-Identifier: BSD-3-Clause
// The outline of an object that lies on its other side.
#pragma once

#include <vector>

#include "matching/scene/scene_level.hpp"
#include "matching/template/contour_template.hpp"

namespace mbncc {

/// [agreement] By which a mirrored outline is no better by chance.
constexpr double kMirrored = 0.04;

class MirroredContour {
 public:
  MirroredContour() = default;

  /// Of an object whose `contour` lies at `home` [px] in `lesson`.
  MirroredContour(const ContourTemplate& contour, const SceneLevel& lesson, const Pose2D& home);

  /// [-2..2] By how much the mirrored outline, `scale` times as large, agrees better with the edges
  /// about `pose` than `contour` does, beyond what it does in the lesson: an outline that is its
  /// own mirror image agrees as well.
  double better(const ContourTemplate& contour, const SceneLevel& scene, const Pose2D& pose,
                double scale) const;

  /// [agreement] From more than this on the object lies on its other side. Half of what the
  /// mirrored outline is behind in the lesson; where that is little, it is better by chance up to
  /// kMirrored.
  double limit() const { return limit_; }

 private:
  ContourTemplate mirrored_;
  std::vector<Pose2D> poses_;  ///< of the mirrored outline, where it comes nearest to the object's
  double usual_ = 0;           ///< surplus in the lesson
  double limit_ = kMirrored;
};

}  // namespace mbncc
