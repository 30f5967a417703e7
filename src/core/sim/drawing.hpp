// SPDX-License-Identifier: BSD-3-Clause
// A sprite drawn once at higher resolution and composited into images at sub-pixel poses.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/sim/scene.hpp"

namespace mbncc::sim {

/// The thing's point p [px] lies at drawing coordinates origin + scale * p.
struct Drawing {
  cv::Mat colour;      ///< CV_32FC3 [grey levels], times cover
  cv::Mat cover;       ///< CV_32FC1 [0..1]
  cv::Point2d origin;  ///< drawing pixel of the thing's origin
  double scale = 4;    ///< drawing pixels per image pixel, a whole number
};

Drawing draw_object(const SceneObject& object);

/// The arm about its grip point, reaching along +x, without its fingers.
Drawing draw_arm_body();

/// One finger about its tip's inner side, reaching along +x, to the side of +y.
Drawing draw_finger();

/// The same sprite mirrored in y.
Drawing mirrored(const Drawing& drawing);

/// CV_32FC1 [0..1] share of each pixel that the drawing at `pose` covers; `where` gets the part of
/// the image that it describes (empty when the drawing lies outside).
cv::Mat coverage(const Drawing& drawing, const Pose2D& pose, cv::Size image, cv::Rect& where);

/// Puts the drawing over `image` (CV_32FC3) with a soft shadow beside it.
void composite(const Drawing& drawing, const Pose2D& pose, double shadow_sigma, cv::Mat& image);

}  // namespace mbncc::sim
