// SPDX-License-Identifier: BSD-3-Clause
// Sub-pixel refinement of pose and scale, with covariance.
#pragma once

#include <opencv2/core.hpp>

#include "matching/refinement/colour_axes.hpp"
#include "matching/refinement/contour_motion.hpp"
#include "matching/template/pose_sample.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::refinement {

/// An object at full resolution.
struct RefinementTemplate {
  RefinementTemplate() = default;
  /// `image` is the one that the surface was made from.
  RefinementTemplate(templates::PoseTemplate made, const scene::PreparedPixels& image);

  templates::PoseTemplate object;
  ColourAxes axes;
  ContourMotion contour_motion;
};

struct Refined {
  Pose2D pose;
  double scale = 1;              ///< of the object, relative to the template
  cv::Matx33d covariance;        ///< of x, y, theta [px^2, px rad, rad^2]
  cv::Matx33d grasp_covariance;  ///< `covariance`, widened if halves of the object are displaced
  double scale_variance = 0;     ///< of `scale`, including its distance from the estimated one
};

/// The unrefined pose with the covariance of unknown accuracy: 100 px, a full turn.
Refined unknown_accuracy(const Pose2D& pose);

/// Least squares over the residuals of the surface along its colour axes and of the contour, from
/// `start` [px, level 0], which may be off by a pixel, and `scale`. `iterations`: largest number of
/// steps; 0: only the covariance is computed. Light may displace contour and colours, and relief
/// the brightness; these shifts along x and y are marginalised. The resulting scale is 1 unless
/// another one is significant. If the steps lead too far away, pose and scale are those of the
/// start.
Refined refine(const RefinementTemplate& object, const scene::SceneLevel& scene,
               const Pose2D& start, int iterations, double scale = 1);

}  // namespace mbncc::refinement
