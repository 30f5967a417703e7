// SPDX-License-Identifier: BSD-3-Clause
// Compares the edges inside an object's outline with an image: parts of one shape and material may
// differ in their print, as domino tiles do.
#pragma once

#include <opencv2/core.hpp>

#include "matching/scene/scene_level.hpp"
#include "matching/template/contour_template.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::evidence {

/// The largest connected group of clear edges inside the outline that only the lesson or only the
/// image shows: its pixels in the lesson, divided by the square root of the area inside. 0: all
/// edges are shared, or there are none.
struct InteriorDifference {
  double largest = 0;
  /// The same of groups that stay 2 px inside the compared area, where most of the outline beside
  /// them is found: of a print. What covers a part of the object hides the outline beside it, or
  /// the cover's edges cross the outline.
  double enclosed = 0;
};

class InteriorEdges {
 public:
  InteriorEdges() = default;

  /// `lesson` shows the view's crop, at least as large as `map` (CV_8UC1), `anchor` [px] in it.
  InteriorEdges(const scene::SceneLevel& lesson, const cv::Mat& map, cv::Point2d anchor);

  /// Edges of highlights, as SurfaceTemplate leaves them out, do not count. The object is `scale`
  /// times as large as in the lesson, with its anchor at `pose`.
  InteriorDifference difference(const scene::SceneLevel& scene,
                                const templates::ContourTemplate& contour, const Pose2D& pose,
                                double scale) const;

 private:
  /// The image's pixels at those of the lesson.
  struct Seen {
    cv::Mat colour;  ///< CV_8UC3
    cv::Mat edges;   ///< CV_8SC2, not turned into the lesson
    cv::Mat inside;  ///< CV_8UC1, 255 inside the image
  };

  Seen at_pose(const scene::PreparedPixels& pixels, const Pose2D& pose, double scale) const;
  cv::Mat without_highlights(const Seen& seen) const;

  cv::Mat colour_;  ///< CV_8UC3
  cv::Mat edges_;   ///< CV_8SC2, see gradient_orientation.hpp
  cv::Mat inside_;  ///< CV_8UC1, 255 inside the outline, a few pixels away from it
  cv::Point2d anchor_;
  double reach_ = 0;  ///< [px] no pixel inside lies farther from the anchor
};

}  // namespace mbncc::evidence
