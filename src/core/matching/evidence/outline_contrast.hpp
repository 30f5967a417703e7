// SPDX-License-Identifier: BSD-3-Clause
// Tells whether the object is a part of something larger, whose colour goes on beyond its outline.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/scene/scene_level.hpp"
#include "matching/template/pose_sample.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::evidence {

/// The colours on both sides of a contour in the lesson.
class OutlineContrast {
 public:
  OutlineContrast() = default;
  /// `contour` lies at `home` in the lesson; the object has this `area` [px].
  OutlineContrast(const templates::ContourTemplate& contour, const scene::SceneLevel& lesson,
                  const Pose2D& home, double area);

  /// Length of the longest connected part of the contour of `object` that shows in the lesson, but
  /// at `pose`, `scale` times as large, has no edge, and the object's colour on both sides in the
  /// light of the image. Length [px] in the lesson, divided by the square root of the area. Under
  /// an occluder, the inner side has another colour. `sample` was read there.
  double longest_continued(const scene::SceneLevel& scene, const templates::PoseTemplate& object,
                           const templates::PoseSample& sample, const Pose2D& pose,
                           double scale) const;

 private:
  std::vector<cv::Vec3f> inside_;
  std::vector<float> contrast_;  // [grey levels] of both sides
  double side_ = 1;              // [px] of a square of the object's area
};

}  // namespace mbncc::evidence
