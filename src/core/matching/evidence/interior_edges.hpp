// SPDX-License-Identifier: BSD-3-Clause
// Compares the edges inside an object's outline with an image: parts of one shape and material may
// differ in their print, as domino tiles do.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/scene/scene_level.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::evidence {

class InteriorEdges {
 public:
  InteriorEdges() = default;

  /// `lesson` shows the view's crop, `map` CV_8UC1 of its size, `anchor` [px] in it.
  InteriorEdges(const scene::SceneLevel& lesson, const cv::Mat& map, cv::Point2d anchor);

  /// [0..1] Part of the strong edges inside the outline, of the lesson and of the image together,
  /// that the other shows as well; 1 where there are too few to tell. The object is `scale` times
  /// as large as in the lesson, with its anchor at `pose`.
  double shared(const scene::SceneLevel& scene, const Pose2D& pose, double scale) const;

 private:
  cv::Mat edges_;   ///< CV_8SC2, see gradient_orientation.hpp
  cv::Mat inside_;  ///< CV_8UC1, 255 inside the outline without its surroundings
  cv::Point2d anchor_;
  std::vector<cv::Point> strong_;  ///< [px] pixels of strong edges inside
  double reach_ = 0;               ///< [px] no pixel inside lies farther from the anchor
};

}  // namespace mbncc::evidence
