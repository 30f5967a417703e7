// SPDX-License-Identifier: BSD-3-Clause
// A sprite drawn once at higher resolution and composited into images at sub-pixel poses.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/sim/scene_content.hpp"

namespace mbncc::sim {

/// The thing's point p [px] lies at drawing coordinates origin + scale * p.
struct Drawing {
  cv::Mat colour;      ///< CV_32FC3 [grey levels], multiplied by cover
  cv::Mat cover;       ///< CV_32FC1 [0..1]
  cv::Point2d origin;  ///< drawing pixel of the thing's origin
  double scale = 4;    ///< drawing pixels per image pixel, an integer
};

Drawing draw_object(const SceneObject& object);

/// The arm without its fingers; the origin is the grip point, and the arm extends along +x.
Drawing draw_arm_body();

/// One finger; the origin is the inner side of its tip, and it extends along +x on the side of +y.
Drawing draw_finger();

/// The same sprite mirrored in y.
Drawing mirrored(const Drawing& drawing);

/// CV_32FC1 [0..1] fraction of each pixel that the drawing at `pose` covers; `where` is set to the
/// part of the image that the result describes (empty if the drawing lies outside).
cv::Mat coverage(const Drawing& drawing, const Pose2D& pose, cv::Size image, cv::Rect& where);

/// Draws the drawing over `image` (CV_32FC3) with a soft shadow beside it.
void composite(const Drawing& drawing, const Pose2D& pose, double shadow_sigma, cv::Mat& image);

}  // namespace mbncc::sim
