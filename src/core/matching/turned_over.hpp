// The outline of an object that lies on its other side.
#pragma once

#include <vector>

#include "matching/contour_template.hpp"
#include "matching/scene_level.hpp"

namespace mbncc {

class TurnedOver {
 public:
  TurnedOver() = default;

  /// Of an object whose `contour` lies at `home` [px] in `lesson`.
  TurnedOver(const ContourTemplate& contour, const SceneLevel& lesson, const Pose2D& home);

  /// [-2..2] By how much the mirrored outline, `scale` times as large, agrees better with the edges
  /// about `pose` than `contour` does, beyond what it does in the lesson: an outline that is its
  /// own mirror image agrees as well.
  double better(const ContourTemplate& contour, const SceneLevel& scene, const Pose2D& pose,
                double scale) const;

  /// The lesson tells the outline from its mirror image.
  bool is_told() const { return told_; }

 private:
  ContourTemplate mirrored_;
  std::vector<Pose2D> poses_;  ///< of the mirrored outline, where it comes nearest to the object's
  double usual_ = 0;           ///< surplus in the lesson
  bool told_ = false;
};

}  // namespace mbncc
