// SPDX-License-Identifier: BSD-3-Clause
// Tells whether the object is a part of something larger, whose colour goes on beyond its outline,
// or has a part that is absent from the image.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/scene/scene_level.hpp"
#include "matching/template/pose_sample.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::evidence {

/// Longest connected parts of the contour that have no edge, and the same colour on both sides.
/// Lengths [px] in the lesson, divided by the square root of the area.
struct MissingContrast {
  double continued = 0;  ///< the object's colour in the light of the image: it is larger
  double absent = 0;     ///< the background's colour: the object ends before
};

/// The colours on both sides of a contour in the lesson. Under an occluder, both sides have other
/// colours.
class OutlineContrast {
 public:
  OutlineContrast() = default;
  /// `contour` lies at `home` in the lesson; the object has this `area` [px].
  OutlineContrast(const templates::ContourTemplate& contour, const scene::SceneLevel& lesson,
                  const Pose2D& home, double area);

  /// Compares both sides of the contour of `object` at `pose`, `scale` times as large. `sample` was
  /// read there.
  MissingContrast missing(const scene::SceneLevel& scene, const templates::PoseTemplate& object,
                          const templates::PoseSample& sample, const Pose2D& pose,
                          double scale) const;

 private:
  std::vector<cv::Vec3f> inside_;
  std::vector<float> contrast_;  // [grey levels] of both sides
  double side_ = 1;              // [px] of a square of the object's area
};

}  // namespace mbncc::evidence
