// SPDX-License-Identifier: BSD-3-Clause
// Compares the edges inside an object's outline with an image: objects of the same shape and
// material may differ only in their print, as domino tiles do.
#pragma once

#include <opencv2/core.hpp>

#include "matching/evidence/lesson_pixels.hpp"
#include "matching/scene/scene_level.hpp"
#include "matching/template/contour_template.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::evidence {

class InteriorEdges {
 public:
  InteriorEdges() = default;

  /// The parameters are those of LessonCrop.
  InteriorEdges(const scene::SceneLevel& lesson, const cv::Mat& map, cv::Point2d anchor);

  /// Largest connected group of clear edges of the lesson or the image that the other lacks, with
  /// the object's anchor at `pose`, `scale` times as large as in the lesson: its number of pixels
  /// in the lesson's frame, divided by the square root of the area inside. Only groups that belong
  /// to a print count: they stay 2 px inside the compared area, and most of the outline beside them
  /// is found. Edges of highlights, as defined in surface_template.hpp, do not count.
  /// `outline` was read there with `contour`.
  double difference(const scene::SceneLevel& scene, const templates::ContourTemplate& contour,
                    const templates::ContourSample& outline, const Pose2D& pose,
                    double scale) const;

 private:
  /// The image resampled at the lesson's pixels.
  struct Seen {
    cv::Mat colour;  ///< CV_8UC3
    cv::Mat edges;   ///< CV_8SC2, vectors not rotated into the lesson's frame
    cv::Mat inside;  ///< CV_8UC1, 255 inside the image
  };

  cv::Mat without_highlights(const Seen& seen) const;

  LessonCrop lesson_;
  cv::Mat edges_;  ///< CV_8SC2, see gradient_orientation.hpp
};

}  // namespace mbncc::evidence
