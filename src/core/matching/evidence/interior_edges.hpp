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

  /// `lesson` shows the view's crop, at least as large as `map` (CV_8UC1), `anchor` [px] in it.
  InteriorEdges(const scene::SceneLevel& lesson, const cv::Mat& map, cv::Point2d anchor);

  /// The largest connected group of clear edges inside the outline that only the lesson or only the
  /// image shows: its pixels, divided by the square root of the area inside. 0: all are shared, or
  /// there are none. Edges of highlights, as SurfaceTemplate leaves them out, do not count. The
  /// object is `scale` times as large as in the lesson, with its anchor at `pose`.
  double difference(const scene::SceneLevel& scene, const Pose2D& pose, double scale) const;

 private:
  cv::Mat compared(const cv::Mat& colour, const Pose2D& pose, double scale) const;
  cv::Mat missing(const cv::Mat& edges, const cv::Mat& where, const Pose2D& pose,
                  double scale) const;
  cv::Mat added(const cv::Mat& edges, const cv::Mat& where, const Pose2D& pose, double scale) const;

  cv::Mat colour_;  ///< CV_8UC3
  cv::Mat edges_;   ///< CV_8SC2, see gradient_orientation.hpp
  cv::Mat inside_;  ///< CV_8UC1, 255 inside the outline, a few pixels away from it
  cv::Point2d anchor_;
  std::vector<cv::Point> clear_;  ///< [px] pixels inside with a clear edge
  double reach_ = 0;              ///< [px] no pixel inside lies farther from the anchor
};

}  // namespace mbncc::evidence
